namespace Alate.Cli;

/// <summary>A free flight: who, where to, in what wind.</summary>
internal sealed record FreePlan
{
    public InsectDefinition Insect { get; init; }

    public FreePilot Pilot { get; init; } = FreePilot.Hover;

    /// <summary>Places that the pilot visits one after the other, metres from the start; the last is held.</summary>
    public IReadOnlyList<float3> Points { get; init; } = [];

    /// <summary>Seed of an erratic track.</summary>
    public int Seed { get; init; } = (int)FlightNumbers.Seed.Default;

    /// <summary>Liveliness of an erratic track, 0 to 1.</summary>
    public double Erratic { get; init; }

    public double Seconds { get; init; } = 10;

    /// <summary>Velocity of a gust of one second in the middle of the flight, m/s.</summary>
    public float3 Gust { get; init; }

    /// <summary>Outer help, 0 to 1.</summary>
    public double Aid { get; init; }

    /// <summary>False follows commands that the insect cannot fly.</summary>
    public bool GuardsCommands { get; init; } = true;

    /// <summary>Seconds of a step.</summary>
    public double Step { get; init; } = FlightNumbers.Step.Default;

    /// <summary>Recorded flight that is flown again in place of all that; null for none.</summary>
    public Replay Replay { get; init; }

    /// <summary>File into which the flight is recorded; null for none.</summary>
    public string RecordFile { get; init; }

    /// <summary>Options of the command line that say where to, as a recording tells them.</summary>
    public string Options { get; init; } = "";

    /// <summary>True where the way is drawn.</summary>
    public bool IsDrawn { get; init; } = true;

    /// <summary>Number of steps.</summary>
    public int Steps => Replay?.Recording.Steps.Count ?? (int)Math.Ceiling(Seconds / Step - 1e-9);

    /// <summary>Record of the run, so that it can be flown again; null for none.</summary>
    public RunRecord Record { get; init; }

    /// <summary>Null is out/SPECIES-free.</summary>
    public string Folder { get; init; }
}
