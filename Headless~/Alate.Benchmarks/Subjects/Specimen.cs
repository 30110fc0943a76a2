using System;
using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>One kind of wing, baked, with its parameters and the air of a level flight at 1.3 m/s.</summary>
internal sealed class Specimen : IDisposable
{
    public const float FlightSpeed = 1.3f;
    private const float k_Gravity = 9.81f;

    public Specimen(SpeciesWing wing)
    {
        Wing = wing;
        var species = wing.CreateSpecies();
        Parameters = species.ToParameters();
        Surface = wing.CreateSurface(WingSide.Right);
        Skeleton = wing.CreateSkeleton(WingSide.Right);
        Rig = Bake();
        Flight = new WingSurroundings
        {
            wind = new float3(0f, 0f, -FlightSpeed / species.WingLength),
            gravity = new float3(0f, -k_Gravity / species.WingLength, 0f),
            speed = FlightSpeed,
        };
    }

    public SpeciesWing Wing { get; }

    public SurfaceMesh Surface { get; }

    public WingSkeleton Skeleton { get; }

    public WingRig Rig { get; }

    public WingParameters Parameters { get; }

    public WingSurroundings Flight { get; }

    public static Specimen Monarch() => new(Species.Find("monarch").Wings[0]);

    /// <summary>A rig of its own; the caller releases it.</summary>
    public WingRig Bake() => WingRig.Bake(
        Skeleton,
        new WingSurface { positions = Surface.positions, normals = Surface.normals, triangles = Surface.triangles },
        WingRigSettings.Default);

    /// <summary>The same flight, a little faster for each wing, so that no two wings move alike.</summary>
    public WingSurroundings FlightOf(int wing)
    {
        var flight = Flight;
        flight.speed *= 1f + 0.002f * (wing % 50);
        flight.wind *= 1f + 0.002f * (wing % 50);
        return flight;
    }

    public void Dispose() => Rig.Release();
}
