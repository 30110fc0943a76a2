using System;
using Alate.Catalogue;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// One kind of wing, baked, with its parameters and the air of a level flight at 0.65 of its top speed: an insect's 1.3 m/s.
/// </summary>
internal sealed class Specimen : IDisposable
{
    private const float k_CruiseShare = 0.65f;
    private readonly WingRigSettings m_Settings;

    public Specimen(WingDefinition wing)
        : this(wing, wing.CreatePreset().ToParameters(), WingRigSettings.Default)
    {
    }

    private Specimen(WingDefinition wing, in WingParameters parameters, in WingRigSettings settings)
    {
        Wing = wing;
        WingPreset preset = wing.CreatePreset();
        Parameters = parameters;
        m_Settings = settings;
        Surface = wing.CreateSurface(WingSide.Right);
        Skeleton = wing.CreateSkeleton(WingSide.Right);
        Rig = Bake();
        float cruise = k_CruiseShare * parameters.maxSpeed;
        Flight = new WingSurroundings
        {
            wind = new float3(0f, 0f, -cruise / preset.WingLength),
            gravity = new float3(0f, -EarthGravity.Size / preset.WingLength, 0f),
            speed = cruise,
        };
    }

    public WingDefinition Wing { get; }

    public SurfaceMesh Surface { get; }

    public WingSkeleton Skeleton { get; }

    public WingRig Rig { get; }

    public WingParameters Parameters { get; }

    public WingSurroundings Flight { get; }

    /// <summary>The monarch by <see cref="OfVersion01"/>.</summary>
    public static Specimen MonarchOfVersion01() => OfVersion01(InsectCatalogue.Find("monarch").Wings[0]);

    /// <summary>
    /// A wing as version 0.1 computed it, and as the plain baselines do: backward Euler, chains apart, 24 substeps, 256 patches.
    /// </summary>
    public static Specimen OfVersion01(WingDefinition wing)
    {
        WingParameters parameters = wing.CreatePreset().ToParameters();
        Version01.ApplyTo(ref parameters);
        parameters.substepsPerBeat = Version01.Substeps;
        return new Specimen(wing, parameters, new WingRigSettings { patchCount = Version01.Patches });
    }

    public static Specimen Monarch() => new(InsectCatalogue.Find("monarch").Wings[0]);

    /// <summary>A rig of its own; the caller releases it.</summary>
    public WingRig Bake() => WingRig.Bake(
        Skeleton,
        new SurfaceMesh { positions = Surface.positions, normals = Surface.normals, triangles = Surface.triangles },
        m_Settings);

    /// <summary>Flight that is a little faster for each wing, so that no two wings move alike.</summary>
    public WingSurroundings FlightOf(int wing)
    {
        WingSurroundings flight = Flight;
        flight.speed *= 1f + 0.002f * (wing % 50);
        flight.wind *= 1f + 0.002f * (wing % 50);
        return flight;
    }

    public void Dispose() => Rig.Release();
}
