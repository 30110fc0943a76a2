using UnityEngine;

namespace Alate.Drawing;

/// <summary>A picture of insects before a wall, on which their shadows fall: first all shadows, then the insects.</summary>
internal sealed class Backdrop
{
    /// <summary>Height of the brightest place over the picture's.</summary>
    private const float k_Highest = 0.42f;

    private readonly BackdropLook m_Look;
    private readonly int2 m_Size;

    /// <summary>[pixel] sRGB.</summary>
    private readonly float3[] m_Shown;

    /// <param name="look">Of the wall.</param>
    /// <param name="size">Columns and rows of the picture.</param>
    public Backdrop(BackdropLook look, int2 size)
    {
        m_Look = look;
        m_Size = size;
        m_Shown = new float3[size.x * size.y];
        float3 middle = Shading.ToLinear(look.Middle), edge = Shading.ToLinear(look.Edge);
        float2 brightest = size * new float2(0.5f, k_Highest);
        float farthest = math.length(math.max(brightest, size - brightest));
        for (int k = 0; k < m_Shown.Length; k++)
        {
            float2 place = new float2(k % size.x, k / size.x) + 0.5f;
            m_Shown[k] = Shading.ToEncoded(math.lerp(middle, edge, math.smoothstep(0f, 1f, math.distance(place, brightest) / farthest)));
        }
    }

    /// <summary>Lays the shadow of an insect on the wall.</summary>
    /// <param name="scene">The insect.</param>
    /// <param name="pose">Its pose.</param>
    /// <param name="panel">What shows it.</param>
    /// <param name="fineness">Pixels of a unit of the panel.</param>
    /// <param name="corner">Column and row at which the panel begins.</param>
    public void Shade(PhotoScene scene, Pose pose, StripPanel panel, float fineness, int2 corner)
    {
        Func<float2, float> light = scene.LightBehind(pose, panel, fineness);
        for (int k = 0; k < m_Shown.Length; k++)
        {
            float left = light(new float2(k % m_Size.x, k / m_Size.x) - corner + 0.5f);
            if (left < 1f)
                m_Shown[k] = Shading.ToEncoded((1f - m_Look.Shade * (1f - left)) * Shading.ToLinear(m_Shown[k]));
        }
    }

    /// <summary>Lays an insect before the wall.</summary>
    /// <param name="cutout">Its pixels with nothing behind them, rows from above.</param>
    /// <param name="size">Columns and rows of them.</param>
    /// <param name="corner">Column and row at which they begin.</param>
    public void Lay(Color32[] cutout, int2 size, int2 corner)
    {
        for (int k = 0; k < cutout.Length; k++)
        {
            int2 place = corner + new int2(k % size.x, k / size.x);
            if (cutout[k].a == 0 || math.any(place < 0) || math.any(place >= m_Size))
                continue;
            ref float3 shown = ref m_Shown[place.y * m_Size.x + place.x];
            shown = math.lerp(shown, new float3(cutout[k].r, cutout[k].g, cutout[k].b) / 255f, cutout[k].a / 255f);
        }
    }

    /// <summary>The picture, rows from above.</summary>
    public Color32[] Pixels() => Array.ConvertAll(m_Shown, Shading.Bytes);
}
