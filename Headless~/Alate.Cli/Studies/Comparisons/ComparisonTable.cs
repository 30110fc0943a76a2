namespace Alate.Cli;

/// <summary>compare.csv: one row for each species, kind of wing and column.</summary>
internal static class ComparisonTable
{
    public static void Write(IReadOnlyList<Comparison> comparisons, Stream stream) => CsvTable.Write(stream, Rows(comparisons));

    private static IEnumerable<IReadOnlyList<string>> Rows(IReadOnlyList<Comparison> comparisons)
    {
        yield return
        [
            "species", "variant", "wing", "column", .. WingMeasure.All.Select(measure => measure.Key),
            "distance_from_full_mean_pct", "distance_from_full_max_pct", "lift_over_weight",
        ];
        foreach (Comparison comparison in comparisons)
        {
            for (int kind = 0; kind < comparison.Flights[0].Summary.Wings.Count; kind++)
            {
                foreach (ComparedFlight flight in comparison.Flights)
                    yield return Row(comparison, flight, kind);
            }
        }
    }

    private static string[] Row(Comparison comparison, ComparedFlight flight, int kind)
    {
        WingSummary wing = flight.Summary.Wings[kind];
        return
        [
            flight.Summary.Flight.Insect.Name, comparison.Plan.Variant.ToString().ToLowerInvariant(), wing.Name, flight.Column.Name,
            .. WingMeasure.All.Select(measure => Number(measure.Of(wing))),
            Number(flight.Distances[kind].MeanPct), Number(flight.Distances[kind].MaxPct), Number(flight.Summary.LiftOverWeight),
        ];
    }

    private static string Number(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);
}
