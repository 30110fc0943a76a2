namespace Alate.Cli;

/// <summary>The tables of the documentation's page: what every species measures, and where its numbers come from.</summary>
internal static class SpeciesTable
{
    /// <summary>One row for each species, variant and kind of wing.</summary>
    public static IEnumerable<IReadOnlyList<string>> Measured(IReadOnlyList<FlightSummary> summaries)
    {
        yield return
        [
            "species", "variant", "wing", "Hz", .. MeasureBound.All.Select(bound => bound.Title),
            "camber %", "tip bend p-p °", "tip lag °", "stretch p99 %", "lift / weight",
        ];
        yield return ["*usual*", "", "", "", .. MeasureBound.All.Select(bound => bound.Range.Replace("*", "\\*")), "", "", "", "", ""];
        foreach (FlightSummary summary in summaries)
        {
            foreach (WingSummary wing in summary.Wings)
                yield return Cells(summary, wing);
        }
    }

    /// <summary>One row for each number.</summary>
    public static IEnumerable<IReadOnlyList<string>> Sources(InsectDefinition species)
    {
        yield return ["number", "variant", "value", "source"];
        foreach (InsectSource source in species.Sources)
            yield return [source.Quantity, source.Variant.ToString().ToLowerInvariant(), source.Value, source.Source];
    }

    private static string[] Cells(FlightSummary summary, WingSummary wing)
    {
        InsectVariant variant = summary.Flight.Plan.Variant;
        return
        [
            summary.Flight.Insect.Name, variant.ToString().ToLowerInvariant(), wing.Name, Number(wing.FrequencyHz, 1),
            .. MeasureBound.All.Select(bound => bound.Cell(wing, variant)),
            $"{Number(wing.CamberMinPct, 1)}…{Number(wing.CamberMaxPct, 1)}", Number(wing.TipBendPpDeg, 1), Number(wing.TipLagDeg, 1),
            Number(wing.EdgeStretchP99Pct, 2), wing == summary.Main ? Number(summary.LiftOverWeight, 2) : "",
        ];
    }

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture).Replace('-', '−');
}
