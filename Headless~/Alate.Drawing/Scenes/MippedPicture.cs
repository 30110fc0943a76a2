using UnityEngine;

namespace Alate.Drawing;

/// <summary>Texture with smaller ones for where it is seen small, as graphics cards keep them.</summary>
internal sealed class MippedPicture
{
    /// <summary>[level][texel] Linear light times opacity, and the opacity; rows from below.</summary>
    private readonly List<float4[]> m_Levels = [];
    private readonly List<int2> m_Sizes = [];

    /// <param name="width">Texels in a row.</param>
    /// <param name="height">Rows.</param>
    /// <param name="texels">Rows from below.</param>
    public MippedPicture(int width, int height, Color[] texels)
    {
        m_Sizes.Add(new int2(width, height));
        m_Levels.Add(Array.ConvertAll(texels, texel =>
        {
            float4 light = Shading.Linear(texel);
            return new float4(light.w * light.xyz, light.w);
        }));
        while (math.cmax(m_Sizes[^1]) > 1)
            Halve();
    }

    /// <summary>Texels of a row, and rows.</summary>
    public int2 Size => m_Sizes[0];

    /// <summary>Linear light and opacity at texture coordinates, which end at the edges.</summary>
    /// <param name="place">From the lower left corner, 0 to 1.</param>
    /// <param name="level">0 for the texture itself, 1 for half its width, and so on; blended between.</param>
    public float4 ColourAt(float2 place, float level)
    {
        float within = math.clamp(level, 0f, m_Levels.Count - 1);
        int lower = (int)within;
        float4 colour = At(lower, place);
        if (lower + 1 < m_Levels.Count)
            colour = math.lerp(colour, At(lower + 1, place), within - lower);
        return new float4(colour.w > 0f ? colour.xyz / colour.w : colour.xyz, colour.w);
    }

    private float4 At(int level, float2 place)
    {
        int2 size = m_Sizes[level];
        float2 texel = math.saturate(place) * (float2)size - 0.5f, share = math.frac(texel);
        int2 low = math.clamp((int2)math.floor(texel), 0, size - 1), high = math.clamp((int2)math.floor(texel) + 1, 0, size - 1);
        float4[] texels = m_Levels[level];
        return math.lerp(
            math.lerp(texels[low.y * size.x + low.x], texels[low.y * size.x + high.x], share.x),
            math.lerp(texels[high.y * size.x + low.x], texels[high.y * size.x + high.x], share.x), share.y);
    }

    private void Halve()
    {
        int2 from = m_Sizes[^1], size = math.max(from / 2, 1);
        float4[] above = m_Levels[^1], texels = new float4[size.x * size.y];
        for (int y = 0; y < size.y; y++)
        {
            for (int x = 0; x < size.x; x++)
            {
                int2 low = math.min(2 * new int2(x, y), from - 1), high = math.min(low + 1, from - 1);
                texels[y * size.x + x] = 0.25f * (above[low.y * from.x + low.x] + above[low.y * from.x + high.x]
                    + above[high.y * from.x + low.x] + above[high.y * from.x + high.x]);
            }
        }

        m_Sizes.Add(size);
        m_Levels.Add(texels);
    }
}
