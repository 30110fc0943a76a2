namespace Alate.Cli;

/// <summary>Measures of one column of the model, with the distance of its wings from those of the full model.</summary>
/// <param name="Summary">The numbers of the last beat.</param>
/// <param name="Distances">[kind of wing] How far the surface lies from the full model's at equal phase.</param>
internal sealed record ComparedFlight(FlightSummary Summary, IReadOnlyList<SurfaceDistance> Distances)
{
    public ComparisonColumn Column => Summary.Flight.Plan.Column;

    public static ComparedFlight Of(FlightRecord record, FlightRecord full) => new(
        FlightSummary.Of(record),
        Enumerable.Range(0, record.Wings.Count).Where(k => !record.Wings[k].Placement.IsLeft)
            .Select(k => SurfaceDistance.Between(record.Wings[k], full.Wings[k])).ToList());
}
