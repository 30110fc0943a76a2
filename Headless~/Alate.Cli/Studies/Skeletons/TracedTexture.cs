using Alate.Authoring;
using Alate.Geometry;
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
    private const double k_RimShare = 0.006, k_LeastRim = 2.0;

    /// <summary>
    /// Contrast to the ground over that of the nearest pixel within the rim, below which one of the rim is mixed with ground.
    /// </summary>
    private const float k_Mixed = 0.8f;

    private readonly int m_Width;
    private readonly int m_Height;
    private readonly Color32[] m_Pixels;

    // [pixel] The one within the rim whose colour it has or is compared with; -1 while there is none.
    private readonly int[] m_Within;
    private Vector3 m_Ground;

    private TracedTexture(WingPicture picture)
    {
        m_Width = picture.Width;
        m_Height = picture.Height;
        m_Pixels = new Color32[m_Width * m_Height];
        m_Within = new int[m_Pixels.Length];
        for (int k = 0; k < m_Pixels.Length; k++)
            m_Pixels[k] = picture[k % m_Width, k / m_Width];
    }

    /// <summary>PNG file of the texture: the picture's own where its ground is transparent.</summary>
    /// <param name="picture">The picture.</param>
    /// <param name="outline">Of the wing, pixels, y down.</param>
    public static byte[] Png(PictureFile picture, Vector2[] outline)
    {
        var texture = new TracedTexture(picture.Picture);
        if (!texture.FindOpaqueGround())
            return picture.Bytes;
        texture.Spread(new PolygonGrid(Array.ConvertAll(outline, point => new PlanPoint(point.x, point.y))));
        return PictureFile.Png(texture.m_Width, texture.m_Height, texture.m_Pixels);
    }

    // The median of the border's opaque pixels; false where most of them are transparent.
    private bool FindOpaqueGround()
    {
        var border = new List<Color32>();
        for (int k = 0; k < m_Pixels.Length; k += IsNextOfBorder(k) ? 1 : m_Width - 1)
            border.Add(m_Pixels[k]);
        List<Color32> opaque = border.FindAll(pixel => pixel.a >= k_Opaque);
        if (2 * opaque.Count <= border.Count)
            return false;
        int Median(Func<Color32, byte> channel) => opaque.Select(channel).Order().ElementAt(opaque.Count / 2);
        m_Ground = new Vector3(Median(pixel => pixel.r), Median(pixel => pixel.g), Median(pixel => pixel.b));
        return true;
    }

    private bool IsNextOfBorder(int pixel) =>
        pixel / m_Width == 0 || pixel / m_Width == m_Height - 1 || pixel % m_Width == m_Width - 1;

    private float Contrast(int pixel) => (new Vector3(m_Pixels[pixel].r, m_Pixels[pixel].g, m_Pixels[pixel].b) - m_Ground).magnitude;

    private PixelMask Inside(PolygonGrid outline)
    {
        var inside = new PixelMask(m_Width, m_Height);
        var crossings = new List<double>();
        for (int row = 0; row < m_Height; row++)
        {
            outline.FindCrossings(row + 0.5, crossings);
            for (int k = 0; k + 1 < crossings.Count; k += 2)
            {
                int last = Math.Min(m_Width - 1, (int)Math.Floor(crossings[k + 1] - 0.5));
                for (int column = Math.Max(0, (int)Math.Ceiling(crossings[k] - 0.5)); column <= last; column++)
                    inside[column, row] = true;
            }
        }

        return inside;
    }

    // Ring by ring from within the rim outwards, to all of the picture.
    private void Spread(PolygonGrid outline)
    {
        PixelMask inside = Inside(outline), within = inside.Shrunk(Math.Max(k_LeastRim, k_RimShare * outline.bounds.Extent));
        var ring = new List<int>();
        for (int k = 0; k < m_Pixels.Length; k++)
        {
            bool isWithin = within[k % m_Width, k / m_Width];
            m_Within[k] = isWithin ? k : -1;
            if (isWithin)
                ring.Add(k);
        }

        while (ring.Count > 0)
        {
            var next = new List<int>();
            foreach (int k in ring)
            {
                int column = k % m_Width;
                if (column > 0)
                    Reach(k, k - 1, inside, next);
                if (column < m_Width - 1)
                    Reach(k, k + 1, inside, next);
                if (k >= m_Width)
                    Reach(k, k - m_Width, inside, next);
                if (k < m_Pixels.Length - m_Width)
                    Reach(k, k + m_Width, inside, next);
            }

            ring = next;
        }
    }

    private void Reach(int from, int to, PixelMask inside, List<int> next)
    {
        if (m_Within[to] >= 0)
            return;
        m_Within[to] = m_Within[from];
        if (!inside[to % m_Width, to / m_Width] || Contrast(to) < k_Mixed * Contrast(m_Within[to]))
            m_Pixels[to] = m_Pixels[from];
        next.Add(to);
    }
}
