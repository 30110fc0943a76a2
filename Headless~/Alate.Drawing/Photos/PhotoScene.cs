using UnityEngine;

namespace Alate.Drawing;

/// <summary>An insect that is ready to be painted at any phase of a beat: its surfaces, the camera and the light.</summary>
internal sealed class PhotoScene
{
    private const float k_DistanceOverReach = 5f, k_Softness = 0.6f, k_TrailDot = 1.3f;

    /// <summary>Pixels of the finest part of a shadow.</summary>
    private const float k_FinestShadow = 2f;

    /// <summary>Blur of a shadow on the wall behind, over the reach.</summary>
    private const float k_WallBlur = 0.07f;

    /// <summary>Nearest places of a trail that are drawn, over the camera's distance.</summary>
    private const float k_NearestTrail = 0.4f;

    private readonly IReadOnlyList<PhotoPart> m_Parts;
    private readonly PictureView m_View;
    private readonly float m_Reach;
    private readonly PictureCamera m_Camera;
    private readonly Shading m_Shading;

    /// <summary>Reach of what casts shadows, without moving air, metres; 0 where there are none.</summary>
    private readonly float m_ShadowReach;

    /// <param name="view">From where it is seen.</param>
    /// <param name="reach">Farthest that any of it comes from the middle of the thorax, metres.</param>
    /// <param name="parts">The body first, then the wings.</param>
    /// <param name="hasShadows">False where colours are numbers that a shadow would falsify.</param>
    public PhotoScene(PictureView view, float reach, IReadOnlyList<PhotoPart> parts, bool hasShadows = true)
        : this(view, reach, parts, hasShadows ? reach : 0f)
    {
    }

    private PhotoScene(PictureView view, float reach, IReadOnlyList<PhotoPart> parts, float shadowReach)
    {
        m_ShadowReach = shadowReach;
        m_Parts = parts;
        m_View = view;
        m_Reach = reach;
        m_Camera = new PictureCamera(view, k_DistanceOverReach * reach);
        m_Shading = new Shading(m_Camera);
    }

    /// <summary>Linear light of the dots along a way.</summary>
    public static float3 TrailLight { get; } = new(0.3f, 0.27f, 0.22f);

    /// <summary>A place on the body, metres, as the camera sees it.</summary>
    public float3 Project(float3 place) => m_Camera.Project(place);

    /// <summary>Returns this insect from another side.</summary>
    public PhotoScene From(PictureView view) => new(view, m_Reach, m_Parts, m_ShadowReach);

    /// <summary>Returns this insect with more parts.</summary>
    /// <param name="parts">What is added.</param>
    /// <param name="reach">Farthest that any of it comes from the middle of the thorax, metres.</param>
    public PhotoScene With(IEnumerable<PhotoPart> parts, float reach) =>
        new(m_View, math.max(reach, m_Reach), [.. m_Parts, .. parts], m_ShadowReach);

    /// <summary>The insect at a phase, 0 to 1 beats.</summary>
    public Pose PoseAt(double turns) => PoseAt(turns, quaternion.identity, float3.zero);

    /// <summary>The insect at a phase, 0 to 1 beats, turned about the middle of its thorax and then moved, metres.</summary>
    /// <param name="turns">The phase.</param>
    /// <param name="turn">How it is turned.</param>
    /// <param name="way">Where it is.</param>
    /// <param name="trail">Where it was; null for nowhere.</param>
    public Pose PoseAt(double turns, quaternion turn, float3 way, IEnumerable<float3> trail = null)
    {
        var pose = new Pose();
        foreach (PhotoPart part in m_Parts)
        {
            (float3[] places, float3[] normals) = part.At(turns);
            float3[] points = Array.ConvertAll(places, place => way + math.rotate(turn, place));
            pose.Points.Add(points);
            pose.Places.Add(Array.ConvertAll(points, m_Camera.Project));
            pose.Normals.Add(Array.ConvertAll(normals, normal => math.rotate(turn, normal)));
        }

        pose.Trail.AddRange((trail ?? []).Select(m_Camera.Project).Where(place => place.z > k_NearestTrail * m_Camera.Distance));
        return pose;
    }

    /// <summary>The insect with its wings as they are made, flat.</summary>
    public Pose Rest()
    {
        Pose pose = PoseAt(0.0);
        for (int k = 0; k < m_Parts.Count; k++)
        {
            if (m_Parts[k].Rest is not { } rest)
                continue;
            pose.Points[k] = rest;
            pose.Places[k] = Array.ConvertAll(rest, m_Camera.Project);
            pose.Normals[k] = Array.ConvertAll(rest, _ => new float3(0f, 1f, 0f));
        }

        return pose;
    }

    /// <summary>Pixels of a panel.</summary>
    public static int2 SizeOf(StripPanel panel, float fineness)
    {
        const float k_Rounding = 1e-3f;
        return (int2)math.ceil(fineness * new float2(panel.Width, panel.Height) - k_Rounding);
    }

    /// <summary>Paints a pose in a panel, rows from above.</summary>
    /// <param name="pose">The pose.</param>
    /// <param name="panel">Where it lies in a picture; only its size and what it shows count.</param>
    /// <param name="fineness">Pixels of a unit of the picture.</param>
    /// <param name="hasPaper">False for pixels that are seen through where nothing is.</param>
    public Color32[] Draw(Pose pose, StripPanel panel, float fineness, bool hasPaper = true)
    {
        int2 size = SizeOf(panel, fineness);
        var grid = new SampleGrid(size.x, size.y);
        Shadows shadows = m_ShadowReach > 0f ? ShadowsOf(pose, k_FinestShadow / (fineness * panel.Scale)) : null;
        for (int k = 0; k < m_Parts.Count; k++)
        {
            float3[] seen = Array.ConvertAll(pose.Places[k], place =>
            {
                float3 placed = panel.Place(place);
                return new float3(SampleGrid.k_Fineness * fineness * placed.xy, placed.z);
            });
            m_Parts[k].Surface.Draw(grid, seen, pose.Normals[k], m_Shading, k_Softness / (fineness * panel.Scale * m_Parts[k].Length),
                shadows == null ? null : Received(shadows, k, pose.Points[k]));
        }

        foreach (float3 place in pose.Trail)
        {
            grid.AddDisc(SampleGrid.k_Fineness * fineness * panel.Place(place).xy,
                SampleGrid.k_Fineness * fineness * k_TrailDot * m_Camera.Distance / place.z, place.z, TrailLight);
        }
        return hasPaper ? grid.Pixels(Shading.ToLinear(Shading.Paper)) : grid.Cutout();
    }

    /// <summary>The light on a wall behind a pose, from beside the viewer's head.</summary>
    /// <param name="pose">The pose.</param>
    /// <param name="panel">What shows it.</param>
    /// <param name="fineness">Pixels of a unit of the panel.</param>
    /// <returns>Share of the light, 0 to 1, that arrives behind a place of the panel, pixels; the place may lie beside the panel.</returns>
    public Func<float2, float> LightBehind(Pose pose, StripPanel panel, float fineness)
    {
        float deepest = pose.Places.SelectMany(places => places).Max(place => place.z) - m_Camera.Distance,
            behind = math.max(deepest, m_Reach), softness = k_WallBlur * m_Reach;
        var map = new ShadowMap(
            Casters(pose), m_Camera.Direction(-0.28f, 0.4f, 1f), softness, k_FinestShadow / (fineness * panel.Scale));
        return place => map.At(-1, m_Camera.Behind(panel.SeenAt(place / fineness), behind));
    }

    private ShadowCaster[] Casters(Pose pose) => [.. m_Parts.Select((part, k) => part.Surface.Caster(pose.Points[k]))];

    // None where no surface lies before another.
    private Shadows ShadowsOf(Pose pose, float finest) => m_Parts.Count(part => part.Surface.CastsShadow) < 2
        ? null
        : new Shadows(Casters(pose), m_Shading.Key, m_ShadowReach, finest);

    // The key light at each sample, that of the sky at the corners of a triangle.
    private static Func<int3, float3, float2> Received(Shadows shadows, int part, float3[] points)
    {
        float[] sky = Array.ConvertAll(points, point => shadows.Sky(part, point));
        return (corners, share) => new float2(
            shadows.Key(part, share.x * points[corners.x] + share.y * points[corners.y] + share.z * points[corners.z]),
            share.x * sky[corners.x] + share.y * sky[corners.y] + share.z * sky[corners.z]);
    }
}
