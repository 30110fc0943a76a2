using System;
using System.Collections.Generic;

namespace Alate.Benchmarks;

/// <summary>Insects of one species in a world of their own; an insect has two wings of each kind.</summary>
internal sealed class Swarm : IDisposable
{
    /// <summary>Substeps of a frame: a monarch's 24 a beat at about 10 Hz, seen at 60 frames per second.</summary>
    public const int SubstepsPerFrame = 4;

    /// <summary>Frames after which a beat begins again.</summary>
    public const int FramesPerBeat = 6;

    /// <summary>Seconds of a frame.</summary>
    public float FrameTime { get; }

    public Swarm(IReadOnlyList<Specimen> kinds, int insects)
    {
        World = new WingWorld();
        Insects = insects;
        var frequency = 0f;
        foreach (var kind in kinds)
        {
            for (var wing = 0; wing < 2 * insects; wing++)
                Wings.Add(World.Add(kind.Rig, kind.Parameters, kind.FlightOf(wing)));
        }

        // Every pack takes the whole number of substeps of a frame: the fastest sets the time.
        foreach (var wing in Wings)
            frequency = MathF.Max(frequency, World.Read(wing).Frequency);
        FrameTime = SubstepsPerFrame / (frequency * kinds[0].Parameters.substepsPerBeat);
    }

    public WingWorld World { get; }

    public int Insects { get; }

    public List<WingHandle> Wings { get; } = [];

    /// <summary>Microseconds per insect and frame.</summary>
    public Contestant Contestant => new($"{Insects} insects", 1000.0 * Insects, Frame, FramesPerBeat);

    /// <summary>A frame: four substeps, and the meshes once.</summary>
    public void Frame()
    {
        World.Step(FrameTime);
        World.Skin();
    }

    public void Dispose() => World.Dispose();
}
