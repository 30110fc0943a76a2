namespace Alate.Cli;

/// <summary>A film of an insect's beat.</summary>
internal sealed record FilmPlan
{
    public const int DefaultBeats = 2, MostBeats = 12, DefaultFrames = 24, LeastFrames = 4, MostFrames = 120, DefaultWidth = 720,
        FreeBeats = 8, FreeFrames = 12, LeastWidth = 120, MostWidth = 1920, DefaultRate = 24, MostRate = 60;

    /// <summary>The flight; its view is where the film begins.</summary>
    public FlightPlan Flight { get; init; }

    /// <summary>The columns beside one another.</summary>
    public IReadOnlyList<ComparisonColumn> Columns { get; init; } = [ComparisonColumn.FullModel];

    /// <summary>True where the insect flies about by its own wings.</summary>
    public bool IsFree { get; init; }

    /// <summary>True where the vortex rings that the wings leave are shown.</summary>
    public bool HasWake { get; init; }

    /// <summary>True where nothing lies behind the insect: pixels without it are seen through.</summary>
    public bool IsTransparent { get; init; }

    /// <summary>Wall behind the insect; null for paper.</summary>
    public BackdropLook? Backdrop { get; init; }

    public int Beats { get; init; } = DefaultBeats;

    /// <summary>Frames of a beat.</summary>
    public int Frames { get; init; } = DefaultFrames;

    /// <summary>Frames a second.</summary>
    public int Rate { get; init; } = DefaultRate;

    /// <summary>Degrees by which the camera goes around the insect in the film.</summary>
    public double Turn { get; init; }

    /// <summary>File that takes the sound; null for none.</summary>
    public string SoundFile { get; init; }

    /// <summary>File that takes the film as a video; null for none.</summary>
    public string VideoFile { get; init; }

    /// <summary>True where the sound is as slow as the film, else it is that of the insect.</summary>
    public bool IsSoundSlow { get; init; }

    /// <summary>Pixels.</summary>
    public int Width { get; init; } = DefaultWidth;
}
