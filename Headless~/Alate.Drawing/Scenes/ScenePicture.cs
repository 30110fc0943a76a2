using UnityEngine;

namespace Alate.Drawing;

/// <summary>Picture of a scene at one moment.</summary>
internal sealed class ScenePicture
{
    /// <summary>Distance from the eye up to which there are shadows, units of the scene; that of Unity's quality settings.</summary>
    private const float k_ShadowDistance = 40f;

    /// <summary>[sample of a pixel] Number of others that are covered before it where a margin covers a part of the pixel.</summary>
    private static readonly float[] s_Covering = [4.5f, 0.5f, 7.5f, 2.5f, 8.5f, 5.5f, 6.5f, 3.5f, 1.5f];

    private readonly SceneCamera m_Camera;
    private readonly SceneLight m_Light;
    private readonly SunMap m_Sun;
    private readonly SampleGrid m_Grid;

    /// <summary>[column] Row and triangle of the pixel that was shaded last, and its light.</summary>
    private readonly (int Row, int Triangle)[] m_Shaded;
    private readonly float4[] m_Shades;
    private int m_Triangle;

    private ScenePicture(SceneCamera camera, IReadOnlyList<SceneSurface> surfaces, SceneLight light)
    {
        m_Camera = camera;
        m_Light = light;
        m_Sun = light.HasSun && light.HasShadows && surfaces.Count > 0
            ? new SunMap(surfaces, light.SunFrom, camera.Place, k_ShadowDistance)
            : null;
        m_Grid = new SampleGrid(camera.Size.x, camera.Size.y);
        m_Shaded = new (int Row, int Triangle)[camera.Size.x];
        m_Shades = new float4[camera.Size.x];
        for (int k = 0; k < surfaces.Count; k++)
            Draw(surfaces[k], k);
    }

    /// <summary>Paints a scene, rows from above.</summary>
    /// <param name="camera">Who looks.</param>
    /// <param name="surfaces">What there is.</param>
    /// <param name="light">The light on it.</param>
    /// <param name="behind">Linear light of what is behind all.</param>
    public static Color32[] Paint(SceneCamera camera, IReadOnlyList<SceneSurface> surfaces, SceneLight light, float3 behind) =>
        new ScenePicture(camera, surfaces, light).m_Grid.Pixels(behind);

    private void Draw(SceneSurface surface, int index)
    {
        float3[] seen = Array.ConvertAll(surface.Places, m_Camera.Seen);
        for (int k = 0; k < surface.Triangles.Length; k += 3)
        {
            var t = new int3(surface.Triangles[k], surface.Triangles[k + 1], surface.Triangles[k + 2]);
            SceneCorner a = new(seen[t.x], new float3(1f, 0f, 0f)), b = new(seen[t.y], new float3(0f, 1f, 0f)),
                c = new(seen[t.z], new float3(0f, 0f, 1f));
            if (math.cmin(new float3(a.Seen.z, b.Seen.z, c.Seen.z)) >= m_Camera.Nearest)
            {
                Draw(surface, index, t, a, b, c);
                continue;
            }

            List<SceneCorner> corners = Before(a, b, c);
            for (int corner = 2; corner < corners.Count; corner++)
                Draw(surface, index, t, corners[0], corners[corner - 1], corners[corner]);
        }
    }

    // The part of a triangle that lies beyond the nearest depth: none, a triangle or a quadrangle.
    private List<SceneCorner> Before(params SceneCorner[] triangle)
    {
        var left = new List<SceneCorner>(4);
        for (int k = 0; k < 3; k++)
        {
            SceneCorner from = triangle[k], to = triangle[(k + 1) % 3];
            bool isSeen = from.Seen.z >= m_Camera.Nearest;
            if (isSeen)
                left.Add(from);
            if (isSeen != to.Seen.z >= m_Camera.Nearest)
            {
                float share = (m_Camera.Nearest - from.Seen.z) / (to.Seen.z - from.Seen.z);
                left.Add(new SceneCorner(math.lerp(from.Seen, to.Seen, share), math.lerp(from.Share, to.Share, share)));
            }
        }

        return left;
    }

    private void Draw(SceneSurface surface, int index, int3 t, SceneCorner a, SceneCorner b, SceneCorner c)
    {
        float2 p = SampleGrid.k_Fineness * m_Camera.Project(a.Seen), q = SampleGrid.k_Fineness * m_Camera.Project(b.Seen),
            r = SampleGrid.k_Fineness * m_Camera.Project(c.Seen);
        float3 near = 1f / new float3(a.Seen.z, b.Seen.z, c.Seen.z);
        (float level, float sharpness) = LevelOf(
            surface, a, b, c, Area(p, q, r) / (SampleGrid.k_Fineness * SampleGrid.k_Fineness), t);
        m_Triangle++;
        TriangleSamples.Visit(p, q, r, (x, y, across) =>
        {
            // Shares on the screen are those on the surface once they are divided by the depths.
            float depth = 1f / math.csum(across * near);
            if (!m_Grid.IsSeen(x, y, depth))
                return;

            // Edges are as fine as samples; within a triangle a pixel has one shade, of its middle or of what is nearest to that.
            var pixel = new int2(x / SampleGrid.k_Fineness, y / SampleGrid.k_Fineness);
            if (m_Shaded[pixel.x] != (pixel.y, m_Triangle))
            {
                float3 weights = near * math.max(TriangleSamples.Shares(p, q, r, SampleGrid.k_Fineness * ((float2)pixel + 0.5f)), 0f);
                weights /= math.csum(weights);
                m_Shades[pixel.x] = At(surface, t, weights.x * a.Share + weights.y * b.Share + weights.z * c.Share, level, sharpness);
                m_Shaded[pixel.x] = (pixel.y, m_Triangle);
            }

            float4 shade = m_Shades[pixel.x];
            if (surface.Look.IsCut)
            {
                int sample = y % SampleGrid.k_Fineness * SampleGrid.k_Fineness + x % SampleGrid.k_Fineness;
                if (shade.w * s_Covering.Length <= s_Covering[sample])
                    return;
                shade.w = 1f;
            }

            m_Grid.Add(x, y, depth, shade, index);
        }, SampleGrid.k_Fineness * m_Camera.Size);
    }

    private float4 At(SceneSurface surface, int3 t, float3 share, float level, float sharpness)
    {
        SceneLook look = surface.Look;
        float3 place = Mean(surface.Places, t, share), normal = math.normalizesafe(Mean(surface.Normals, t, share)),
            toEye = math.normalizesafe(m_Camera.Place - place);
        float4 colour = look.Tint;
        if (look.Picture != null && surface.Coordinates is { } uvs)
            colour *= look.Picture.ColourAt(share.x * uvs[t.x] + share.y * uvs[t.y] + share.z * uvs[t.z], level);
        if (look.ShowsColours && surface.Colours is { } colours)
            colour *= share.x * colours[t.x] + share.y * colours[t.y] + share.z * colours[t.z];
        float sun = m_Sun?.At(place) ?? 1f;
        float opacity = look.IsTranslucent ? colour.w : look.IsCut ? math.saturate(sharpness * (colour.w - 0.5f) + 0.5f) : 1f;
        return new float4(m_Light.Of(look, colour.xyz, place, normal, toEye, sun), opacity);
    }

    // Texels that a pixel covers, as a level of the texture; and where it covers less than one, pixels along a texel.
    private static (float Level, float Sharpness) LevelOf(
        SceneSurface surface, SceneCorner a, SceneCorner b, SceneCorner c, float pixels, int3 t)
    {
        if (surface.Look.Picture == null || surface.Coordinates is not { } uvs || pixels <= 0f)
            return (0f, 1f);
        float2 size = surface.Look.Picture.Size;
        float texels = Area(At(a), At(b), At(c));
        float finer = 0.5f * math.log2(math.max(texels / pixels, 1e-6f));
        return (math.max(finer, 0f), math.exp2(math.max(-finer, 0f)));

        float2 At(SceneCorner corner) =>
            size * (corner.Share.x * uvs[t.x] + corner.Share.y * uvs[t.y] + corner.Share.z * uvs[t.z]);
    }

    private static float3 Mean(float3[] values, int3 t, float3 share) =>
        share.x * values[t.x] + share.y * values[t.y] + share.z * values[t.z];

    private static float Area(float2 a, float2 b, float2 c)
    {
        float2 p = b - a, q = c - a;
        return 0.5f * math.abs(p.x * q.y - p.y * q.x);
    }

    /// <summary>Corner of what is drawn of a triangle.</summary>
    /// <param name="Seen">Position from the eye.</param>
    /// <param name="Share">Shares of the corners of the triangle.</param>
    private readonly record struct SceneCorner(float3 Seen, float3 Share);
}
