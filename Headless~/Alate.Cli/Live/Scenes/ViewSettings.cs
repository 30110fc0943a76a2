namespace Alate.Cli;

/// <summary>Settings of what a page shows: an insect and how it flies.</summary>
internal sealed record ViewSettings
{
    /// <summary>The flight of the whole model.</summary>
    public FlightPlan Flight { get; init; }

    public string Species => Flight.Species;

    public InsectVariant Variant => Flight.Variant;

    /// <summary>Simulated time over that of the viewer.</summary>
    public double Slow { get; init; }

    /// <summary>True for the columns of the model beside one another.</summary>
    public bool IsCompared { get; init; }

    public bool IsPaused { get; init; }

    /// <summary>True where the air behind the wings is shown.</summary>
    public bool HasWake { get; init; }

    /// <summary>True where the insect flies to a perch and lands, in place of beating on the spot.</summary>
    public bool IsLanding { get; init; }

    /// <summary>The columns to show.</summary>
    public IReadOnlyList<ComparisonColumn> Columns => IsCompared ? ComparisonColumn.All : [ComparisonColumn.FullModel];

    /// <summary>A species as it is, in level flight, about one beat a second on the page.</summary>
    public static ViewSettings Of(InsectDefinition species, InsectVariant variant)
    {
        WingPreset preset = species.Wings[0].CreatePreset(ModelReading.Physical, variant);
        var settings = new ViewSettings
        {
            Flight = FlightNumbers.Wind.In(FlightPlan.Cruise(species, variant), 0) with
            {
                Lag = Math.Round(preset.Wave.chordDelay, 4),
                Substeps = preset.SubstepsPerBeat,
            },
            Slow = Math.Round(Math.Clamp(0.8 / preset.Beat.maxFrequency, 0.001, 1), 3),
        };
        UnityEngine.Object.DestroyImmediate(preset);
        return settings;
    }

    /// <summary>A species that lands on a perch, slow enough for its beat to be seen at 30 states a second.</summary>
    /// <exception cref="UserException">It does not land.</exception>
    public static ViewSettings Landing(InsectDefinition species)
    {
        const double k_Slower = 4;
        if (!PerchFlight.CanLand(species))
        {
            throw new UserException(
                $"The {species.DisplayName} does not land: only insects of the catalogue that fly in air do. Choose another insect.");
        }

        ViewSettings settings = Of(species, InsectVariant.Flight);
        return settings with { IsLanding = true, Slow = Math.Round(Math.Min(k_Slower * settings.Slow, 1), 3) };
    }

    /// <summary>The flight of a column.</summary>
    public FlightPlan Plan(ComparisonColumn column) => Flight with
    {
        // The others have no wave that could be late.
        Lag = column == ComparisonColumn.RigidWing || column == ComparisonColumn.NoWave ? null : Flight.Lag,
        Column = column,
    };
}
