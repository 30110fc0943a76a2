namespace Alate.Cli;

/// <summary>Numbers of a flown insect that are so far from real ones that their unit may be another one.</summary>
internal static class UnitDoubts
{
    /// <summary>Least flap of a wing that beats, degrees from end to end, and largest factor between its EI and measured ones.</summary>
    private const double k_LeastFlap = 5, k_MostFactor = 30;

    /// <summary>One question for each doubt, with the wing and the number.</summary>
    public static IEnumerable<string> Of(FlightSummary summary)
    {
        foreach (WingSummary wing in summary.Wings)
        {
            WingPreset preset = summary.Flight.Wings.First(one => one.Wing.Name == wing.Name).Wing.Preset;
            if (AboutFlap(wing.Name, FlapOf(preset)) is string flap)
                yield return flap;
            if (AboutStiffness(wing.Name, wing.Stiffness.Whole, wing.Stiffness.Usual) is string stiffness)
                yield return stiffness;
        }
    }

    /// <summary>Doubt about a flap; null for none.</summary>
    /// <param name="name">Name of the wing.</param>
    /// <param name="degrees">From end to end; 0 is a wing that is held.</param>
    public static string AboutFlap(string name, double degrees) => degrees is > 0 and < k_LeastFlap
        ? FormattableString.Invariant(
            $"The {name} flaps by {degrees:0.###}° from end to end: were radians meant? ")
            + FormattableString.Invariant($"{degrees:0.###} rad are {math.degrees(degrees):0.#}°.")
        : null;

    /// <summary>Doubt about a stiffness; null for none.</summary>
    /// <param name="name">Name of the wing.</param>
    /// <param name="stiffness">Of all its chains, N m².</param>
    /// <param name="usual">Measured on wings of its length, N m².</param>
    public static string AboutStiffness(string name, double stiffness, double usual) =>
        stiffness > k_MostFactor * usual || stiffness * k_MostFactor < usual
            ? FormattableString.Invariant(
                $"The {name} has an EI of {stiffness:0.0e-0} N m², {stiffness / usual:G2} of what Combes and Daniel 2003 ")
                + "measured on wings of its length: is the unit N m²?"
            : null;

    private static double FlapOf(WingPreset preset) => preset.Kinematics.prescribed
        ? 2.0 * (preset.Kinematics.flap.harmonics?.Sum(harmonic => Math.Abs(harmonic.x)) ?? 0.0)
        : preset.Beat.flapRange;
}
