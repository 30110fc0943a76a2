using System;
using Alate.Catalogue;
using Alate.Cli;

namespace Alate.Tests.Cli;

/// <summary>A flight of four wings of two kinds of which no number has its default, flown once for all tests.</summary>
internal static class OddFlight
{
    private static readonly Lazy<FlightRecord> s_Flown = new(() => TetheredFlight.Fly(Plan));

    public static FlightPlan Plan { get; } = new()
    {
        Species = "fishfly",
        Variant = InsectVariant.Expressive,
        Speed = 1.5,
        Climb = 0.75,
        PitchDegrees = 20,
        Wind = [0.5, 0.25, -1],
        Induced = new InducedFlow(1.5),
        AddedMass = true,
        Lag = 0.15,
        Elasticity = 2,
        Substeps = 20,
        Patches = 128,
        Coefficients = CoefficientSet.FlatPlate,
        Seconds = 0.5,
    };

    public static FlightRecord Record => s_Flown.Value;
}
