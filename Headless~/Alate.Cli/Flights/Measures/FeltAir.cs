namespace Alate.Cli;

/// <summary>
/// Air that wings feel as slower than it is: beyond the strongest wind that bends them freely they feel its fourth root (see
/// <see cref="WingParameters.strongestWind"/>), so that forces are not those of a wing in that air.
/// </summary>
internal static class FeltAir
{
    /// <summary>Share of the air that is felt, below which it is said.</summary>
    private const double k_Least = 0.98;

    /// <summary>A line for each kind of wing that feels less air than it meets.</summary>
    public static IEnumerable<string> Of(FlightPlan plan, IReadOnlyList<RecordedWing> wings)
    {
        double air = math.length(plan.AirPastBody);
        foreach (RecordedWing wing in wings.Where(wing => !wing.Placement.IsLeft))
        {
            double strongest = Strongest(wing), felt = Felt(wing, air);
            if (felt < k_Least * air)
            {
                yield return FormattableString.Invariant(
                    $"The {wing.Wing.Name} meets air at {air:0.#} m/s and feels {felt:0.#} m/s of it, as its strongest wind is ")
                    + FormattableString.Invariant($"{strongest:0.#} m/s: are its forces wanted? ")
                    + "strongestWind 1000 takes the air as it is.";
            }
        }
    }

    /// <summary>Speed of the air that a wing feels, m/s.</summary>
    /// <param name="wing">The wing.</param>
    /// <param name="air">Speed of the air past the body, m/s.</param>
    public static double Felt(RecordedWing wing, double air) => wing.Parameters.options.coupling == MembraneCoupling.OneWay
        ? air
        : air * StrongestWind.FeltShare((float)(air / Strongest(wing))).x;

    private static double Strongest(RecordedWing wing) =>
        LaneParameters.StrongestWindOf(wing.Parameters) * wing.Wing.Preset.Size.wingLength;
}
