using System;
using System.Collections.Generic;
using Alate.Catalogue;

namespace Alate.Cli;

/// <summary>Settings of what a page shows: an insect and how it flies.</summary>
internal sealed record ViewSettings
{
    public string Species { get; init; }

    public InsectVariant Variant { get; init; }

    /// <summary>Simulated time over that of the viewer.</summary>
    public double Slow { get; init; }

    /// <summary>Of the body ahead, m/s.</summary>
    public double Speed { get; init; }

    /// <summary>From ahead, m/s.</summary>
    public double Wind { get; init; }

    /// <summary>Factor on the species'.</summary>
    public double Elasticity { get; init; } = 1;

    /// <summary>λ, half beats.</summary>
    public double Delay { get; init; }

    /// <summary>Factor on the species'.</summary>
    public double Amplitude { get; init; } = 1;

    /// <summary>Factor on the species'.</summary>
    public double Frequency { get; init; } = 1;

    public int Substeps { get; init; }

    /// <summary>True for the columns of the model beside one another.</summary>
    public bool IsCompared { get; init; }

    public bool IsPaused { get; init; }

    /// <summary>The columns to show.</summary>
    public IReadOnlyList<ComparisonColumn> Columns => IsCompared ? ComparisonColumn.All : [ComparisonColumn.FullModel];

    /// <summary>A species as it is, in level flight, about one beat a second on the page.</summary>
    public static ViewSettings Of(InsectDefinition species, InsectVariant variant)
    {
        WingPreset preset = species.Wings[0].CreatePreset(ModelReading.Physical, variant);
        var settings = new ViewSettings
        {
            Species = species.Name,
            Variant = variant,
            Slow = Math.Round(Math.Clamp(0.8 / preset.Beat.maxFrequency, 0.001, 1), 3),
            Speed = FlightPlan.CruiseOf(species),
            Delay = Math.Round(preset.Wave.chordDelay, 4),
            Substeps = preset.SubstepsPerBeat,
        };
        UnityEngine.Object.DestroyImmediate(preset);
        return settings;
    }

    /// <summary>The flight of a column.</summary>
    public FlightPlan Plan(ComparisonColumn column) => new()
    {
        Species = Species,
        Variant = Variant,
        Speed = Speed,
        Wind = [0, 0, -Wind],
        Elasticity = Elasticity,
        // The others have no wave that could be late.
        Lag = column == ComparisonColumn.RigidWing || column == ComparisonColumn.NoWave ? null : Delay,
        Amplitude = Amplitude,
        Frequency = Frequency,
        Substeps = Substeps,
        Column = column,
    };
}
