using Alate.Authoring;
using UnityEngine;

namespace Alate.Cli;

/// <summary>
/// Texture of a traced wing: the picture in which the wing's colours run out over an opaque ground. The ground's colour would show at the
/// rim of the mesh, which lies halfway through a blurred edge, and in small mipmaps.
/// </summary>
internal sealed class TracedTexture
{
    /// <summary>Opacity below which a pixel is transparent.</summary>
    private const int k_Opaque = 128;

    /// <summary>Width of the rim that may be mixed with ground, as a share of the wing's extent, and the least, pixels.</summary>
    private const float k_RimShare = 0.006f, k_LeastRim = 2f;

    /// <summary>
    /// Contrast to the ground over that of the nearest pixel within the rim, below which one of the rim is mixed with ground.
    /// </summary>
    private const float k_Mixed = 0.8f;

    private readonly WingPicture m_Picture;
    private readonly Color32[] m_Pixels;
    private readonly bool[] m_IsWing;
    private readonly bool[] m_IsInside;
    private readonly int[] m_Within;
    private Vector3 m_Ground;

    private TracedTexture(WingPicture picture)
    {
        m_Picture = picture;
        m_Pixels = new Color32[picture.Width * picture.Height];
        m_IsWing = new bool[m_Pixels.Length];
        m_IsInside = new bool[m_Pixels.Length];
        m_Within = new int[m_Pixels.Length];
        for (int k = 0; k < m_Pixels.Length; k++)
        {
            m_Pixels[k] = picture[k % picture.Width, k / picture.Width];
            m_Within[k] = k;
        }
    }

    /// <summary>PNG file of the texture: the picture's own where its ground is transparent.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="outline">Of the wing, pixels, y down.</param>
    public static byte[] Png(PictureFile picture, Vector2[] outline)
    {
        var texture = new TracedTexture(picture.Picture);
        if (!texture.FindOpaqueGround())
            return picture.Bytes;
        texture.Fill(outline);
        texture.m_IsWing.CopyTo(texture.m_IsInside, 0);
        float width = outline.Max(point => point.x) - outline.Min(point => point.x);
        float height = outline.Max(point => point.y) - outline.Min(point => point.y);
        texture.Spread(isWing: false, (int)Math.Max(k_LeastRim, k_RimShare * Math.Max(width, height)));
        texture.Spread(isWing: true, int.MaxValue);
        return PictureFile.Png(picture.Picture.Width, picture.Picture.Height, texture.m_Pixels);
    }

    // The median of the border's opaque pixels; false where most of them are transparent.
    private bool FindOpaqueGround()
    {
        int width = m_Picture.Width, height = m_Picture.Height;
        var border = new List<Color32>();
        for (int k = 0; k < m_Pixels.Length; k += k / width is 0 || k / width == height - 1 || k % width == width - 1 ? 1 : width - 1)
            border.Add(m_Pixels[k]);
        List<Color32> opaque = border.FindAll(pixel => pixel.a >= k_Opaque);
        if (2 * opaque.Count <= border.Count)
            return false;
        int Median(Func<Color32, byte> channel) => opaque.Select(channel).Order().ElementAt(opaque.Count / 2);
        m_Ground = new Vector3(Median(pixel => pixel.r), Median(pixel => pixel.g), Median(pixel => pixel.b));
        return true;
    }

    private float Contrast(Color32 pixel) => (new Vector3(pixel.r, pixel.g, pixel.b) - m_Ground).magnitude;

    // By rows: between the first and the second crossing, the third and the fourth, and so on.
    private void Fill(Vector2[] outline)
    {
        var crossings = new List<float>();
        for (int row = 0; row < m_Picture.Height; row++)
        {
            float y = row + 0.5f;
            crossings.Clear();
            for (int k = 0, before = outline.Length - 1; k < outline.Length; before = k++)
            {
                Vector2 a = outline[before], b = outline[k];
                if (a.y <= y != b.y <= y)
                    crossings.Add(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
            }

            crossings.Sort();
            for (int k = 0; k + 1 < crossings.Count; k += 2)
            {
                int from = Math.Max(0, (int)MathF.Ceiling(crossings[k] - 0.5f));
                int to = Math.Min(m_Picture.Width - 1, (int)MathF.Floor(crossings[k + 1] - 0.5f));
                if (to >= from)
                    Array.Fill(m_IsWing, true, row * m_Picture.Width + from, to - from + 1);
            }
        }
    }

    // Lets wing or ground grow by so many pixels; wing takes its colours with it.
    private void Spread(bool isWing, int far)
    {
        int width = m_Picture.Width;
        var edge = new List<int>();
        for (int k = 0; k < m_IsWing.Length; k++)
        {
            if (m_IsWing[k] == isWing)
                edge.Add(k);
        }

        for (int step = 0; step < far && edge.Count > 0; step++)
        {
            var next = new List<int>();
            foreach (int k in edge)
            {
                Reach(k, k - 1, k % width > 0, isWing, next);
                Reach(k, k + 1, k % width < width - 1, isWing, next);
                Reach(k, k - width, k >= width, isWing, next);
                Reach(k, k + width, k < m_IsWing.Length - width, isWing, next);
            }

            edge = next;
        }
    }

    private void Reach(int from, int to, bool isThere, bool isWing, List<int> next)
    {
        if (!isThere || m_IsWing[to] == isWing)
            return;
        m_IsWing[to] = isWing;
        if (isWing)
        {
            m_Within[to] = m_Within[from];
            if (!m_IsInside[to] || Contrast(m_Pixels[to]) < k_Mixed * Contrast(m_Pixels[m_Within[to]]))
                m_Pixels[to] = m_Pixels[from];
        }

        next.Add(to);
    }
}
