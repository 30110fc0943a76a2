using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures.Photos;

/// <summary>An insect that was flown, ready to be painted at any phase of its last beat: its surfaces, the camera and the light.</summary>
internal sealed class PhotoScene
{
    private const float k_DistanceOverReach = 5f, k_Softness = 0.6f, k_TrailDot = 1.3f;

    /// <summary>Nearest places of a trail that are drawn, over the camera's distance.</summary>
    private const float k_NearestTrail = 0.4f;

    private readonly FlightRecord m_Flight;
    private readonly List<PhotoSurface> m_Surfaces;
    private readonly PictureCamera m_Camera;
    private readonly Shading m_Shading;

    /// <param name="flight">What was flown.</param>
    /// <param name="view">From where it is seen.</param>
    /// <param name="surfaceOf">Looks of the wings, by their numbers; null for their own.</param>
    public PhotoScene(FlightRecord flight, PictureView view, Func<int, RecordedWing, PhotoSurface> surfaceOf = null)
        : this(flight, view, [PhotoSurface.Of(flight.Insect.Body), .. flight.Wings.Select((wing, k) => (surfaceOf ?? PhotoSurface.Of)(k + 1, wing))])
    {
    }

    private PhotoScene(FlightRecord flight, PictureView view, List<PhotoSurface> surfaces)
    {
        m_Flight = flight;
        m_Surfaces = surfaces;
        m_Camera = new PictureCamera(view, k_DistanceOverReach * flight.Wings.Max(wing => math.length(wing.Placement.Hinge) + wing.Placement.Length));
        m_Shading = new Shading(m_Camera);
    }

    /// <summary>Linear light of the dots along a way.</summary>
    public static float3 TrailLight { get; } = new(0.3f, 0.27f, 0.22f);

    /// <summary>Returns this insect from another side.</summary>
    public PhotoScene From(PictureView view) => new(m_Flight, view, m_Surfaces);

    /// <summary>The insect at a phase, 0 to 1 beats.</summary>
    public Pose PoseAt(double turns) => PoseAt(turns, quaternion.identity, float3.zero);

    /// <summary>The insect at a phase, 0 to 1 beats, turned about the middle of its thorax and then moved, metres.</summary>
    /// <param name="turns">The phase.</param>
    /// <param name="turn">How it is turned.</param>
    /// <param name="way">Where it is.</param>
    /// <param name="trail">Where it was; null for nowhere.</param>
    public Pose PoseAt(double turns, quaternion turn, float3 way, IEnumerable<float3> trail = null)
    {
        SurfaceMesh body = m_Flight.Insect.Body;
        var pose = new Pose();
        pose.Places.Add(Array.ConvertAll(body.positions, place => Seen(place)));
        pose.Normals.Add(Array.ConvertAll(body.normals, normal => math.rotate(turn, normal)));
        foreach (RecordedWing wing in m_Flight.Wings)
        {
            var positions = new float3[wing.Rest.Length];
            var normals = new float3[wing.Rest.Length];
            wing.At(turns, positions, normals);
            pose.Places.Add(Array.ConvertAll(positions, Seen));
            pose.Normals.Add(Array.ConvertAll(normals, normal => math.rotate(turn, normal)));
        }

        pose.Trail.AddRange((trail ?? []).Select(m_Camera.Project).Where(place => place.z > k_NearestTrail * m_Camera.Distance));
        return pose;

        float3 Seen(float3 place) => m_Camera.Project(way + math.rotate(turn, place));
    }

    /// <summary>The insect with its wings as they are made, flat.</summary>
    public Pose Rest()
    {
        Pose pose = PoseAt(0.0);
        for (int k = 0; k < m_Flight.Wings.Count; k++)
        {
            RecordedWing wing = m_Flight.Wings[k];
            pose.Places[k + 1] = Array.ConvertAll(wing.Rest, place => m_Camera.Project(wing.Placement.ToBody(place)));
            pose.Normals[k + 1] = Array.ConvertAll(wing.Rest, _ => new float3(0f, 1f, 0f));
        }

        return pose;
    }

    /// <summary>Pixels of a panel.</summary>
    public static int2 SizeOf(StripPanel panel, float fineness) => (int2)math.ceil(fineness * new float2(panel.Width, panel.Height));

    /// <summary>Paints a pose in a panel, rows from above.</summary>
    /// <param name="pose">The pose.</param>
    /// <param name="panel">Where it lies in a picture; only its size and what it shows count.</param>
    /// <param name="fineness">Pixels of a unit of the picture.</param>
    public Color32[] Draw(Pose pose, StripPanel panel, float fineness)
    {
        int2 size = SizeOf(panel, fineness);
        var grid = new SampleGrid(size.x, size.y);
        for (int k = 0; k < m_Surfaces.Count; k++)
        {
            float3[] seen = Array.ConvertAll(pose.Places[k], place =>
            {
                float3 placed = panel.Place(place);
                return new float3(SampleGrid.k_Fineness * fineness * placed.xy, placed.z);
            });
            float length = k == 0 ? 1f : m_Flight.Wings[k - 1].Placement.Length;
            m_Surfaces[k].Draw(grid, seen, pose.Normals[k], m_Shading, k_Softness / (fineness * panel.Scale * length));
        }

        foreach (float3 place in pose.Trail)
            grid.AddDisc(SampleGrid.k_Fineness * fineness * panel.Place(place).xy, SampleGrid.k_Fineness * fineness * k_TrailDot * m_Camera.Distance / place.z, place.z, TrailLight);
        return grid.Pixels(Shading.ToLinear(PixelPage.Paper));
    }
}
