using System;
using System.Collections.Generic;

namespace Alate.Benchmarks;

/// <summary>Insects of one species in a world of their own; an insect has two wings of each kind.</summary>
internal sealed class Swarm : IDisposable
{
    /// <summary>A monarch at about 10 Hz, seen at 60 frames per second.</summary>
    public const int FramesPerBeat = 6;

    private int m_Frame;

    public Swarm(IReadOnlyList<Specimen> kinds, int insects)
    {
        World = new WingWorld();
        Insects = insects;
        float frequency = 0f;
        foreach (Specimen kind in kinds)
        {
            for (int wing = 0; wing < 2 * insects; wing++)
                Wings.Add(World.Add(kind.Rig, kind.Parameters, kind.FlightOf(wing)));
        }

        // Every pack takes the whole number of substeps of a frame: the fastest sets the time.
        foreach (WingHandle wing in Wings)
            frequency = MathF.Max(frequency, World.Read(wing).Frequency);
        SubstepsPerBeat = (int)kinds[0].Parameters.substepsPerBeat;
        Substep = 1f / (frequency * SubstepsPerBeat);
    }

    /// <summary>Seconds of a substep.</summary>
    public float Substep { get; }

    public int SubstepsPerBeat { get; }

    public WingWorld World { get; }

    public int Insects { get; }

    public List<WingHandle> Wings { get; } = [];

    /// <summary>Microseconds per insect and frame.</summary>
    public Contestant Contestant => new($"{Insects} insects", 1000.0 * Insects, Frame, FramesPerBeat);

    /// <summary>Microseconds per insect and beat, without meshes.</summary>
    public Contestant Beats => new($"{Insects} insects", 1000.0 * Insects, Beat);

    /// <summary>Substeps of the next frame: where a beat's do not go evenly into its frames, some have one more than others.</summary>
    public int SubstepsDue => (m_Frame + 1) * SubstepsPerBeat / FramesPerBeat - m_Frame * SubstepsPerBeat / FramesPerBeat;

    /// <summary>Seconds of the next frame.</summary>
    public float TimeDue => SubstepsDue * Substep;

    /// <summary>A frame: its substeps, and the meshes once.</summary>
    public void Frame()
    {
        World.Step(TimeDue);
        World.Skin();
        m_Frame = (m_Frame + 1) % FramesPerBeat;
    }

    private void Beat() => World.Step(SubstepsPerBeat * Substep);

    public void Dispose() => World.Dispose();
}
