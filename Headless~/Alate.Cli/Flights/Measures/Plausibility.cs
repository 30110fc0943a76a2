namespace Alate.Cli;

/// <summary>Numbers of an insect beside those of real ones, and questions about their units and the air.</summary>
/// <param name="Wings">Groups of each kind of wing.</param>
/// <param name="Doubts">A question for each number whose unit may be another one, and for air that is not felt as it is.</param>
internal sealed record Plausibility(IReadOnlyList<WingGroups> Wings, IReadOnlyList<string> Doubts)
{
    /// <summary>Groups with a number outside of their range.</summary>
    public IEnumerable<GroupBound> Outside => GroupBound.All.Where(bound => !Wings.All(bound.Holds));

    /// <summary>Of an insect that has flown.</summary>
    public static Plausibility Of(FlightRecord flight) => Of(flight.Plan, flight.Wings);

    /// <summary>Of an insect that is to fly.</summary>
    /// <exception cref="UserException">It cannot.</exception>
    public static Plausibility Of(FlightPlan plan)
    {
        using var wings = new TetheredWings(plan, Insect.Of(plan));
        return Of(plan, wings.All);
    }

    private static Plausibility Of(FlightPlan plan, IReadOnlyList<RecordedWing> wings) =>
        new(WingGroups.Of(plan, wings), [.. UnitDoubts.Of(plan, wings), .. FeltAir.Of(plan, wings)]);
}
