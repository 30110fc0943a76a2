namespace Alate.Cli;

/// <summary>A film of a sample scene that plays in real time.</summary>
internal sealed record SceneFilmPlan
{
    public const int MostSeconds = 120, MostExposures = 16, DefaultRate = 30;

    public const double DefaultSeconds = 6.0;

    /// <summary>The sample.</summary>
    public SampleScene Scene { get; init; }

    /// <summary>Seconds that the film shows.</summary>
    public double Seconds { get; init; } = DefaultSeconds;

    /// <summary>Seconds that go by before it begins.</summary>
    public double After { get; init; }

    /// <summary>Sliders and buttons of the sample's own panel, and what they are set to.</summary>
    public IReadOnlyList<string> Settings { get; init; } = [];

    /// <summary>
    /// Direction and distance of the camera: degrees to the side, degrees down, units of the scene; then the point that it looks at, where
    /// it is not the sample's own. Empty for all as the sample has it.
    /// </summary>
    public double[] Look { get; init; } = [];

    /// <summary>Degrees by which the camera goes around in the film.</summary>
    public double Turn { get; init; }

    /// <summary>Frames a second.</summary>
    public int Rate { get; init; } = DefaultRate;

    /// <summary>Moments of half a frame that are one picture; 1 is sharp.</summary>
    public int Exposures { get; init; } = 1;

    /// <summary>Pixels from side to side.</summary>
    public int Width { get; init; } = FilmPlan.DefaultWidth;

    /// <summary>File that takes the film as a video; null for none.</summary>
    public string VideoFile { get; init; }

    /// <summary>Columns and rows, nine sixteenths as many, even for video.</summary>
    public int2 Size => new(Width, 2 * (int)Math.Round(Width * 9.0 / 32.0));

    /// <summary>Number of frames, at least 1.</summary>
    public int Count => Math.Max((int)Math.Round(Seconds * Rate), 1);
}
