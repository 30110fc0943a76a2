using Alate.Catalogue;
using Alate.Cli;

namespace Alate.Tests.Cli;

/// <summary>A flight of four wings of two kinds of which no number has its default.</summary>
internal static class OddFlight
{
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

    public static FlightRecord Fly() => TetheredFlight.Fly(Plan);
}
