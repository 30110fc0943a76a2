using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Alate.Cli.Flights;

namespace Alate.Cli.Figures;

/// <summary>The documentation's table of what every species measures, as Markdown.</summary>
internal static class SpeciesTable
{
    public static string Write(IReadOnlyList<FlightSummary> summaries)
    {
        var text = new StringBuilder();
        Row(text, ["species", "variant", "wing", "Hz", .. MeasureBound.All.Select(bound => bound.Title), "camber %", "tip bend p-p °", "tip lag °", "stretch p99 %", "lift / weight"]);
        Row(text, Enumerable.Repeat("---", 9 + MeasureBound.All.Count));
        Row(text, ["*bound*", "", "", "", .. MeasureBound.All.Select(bound => bound.Range), "", "", "", "", ""]);
        foreach (FlightSummary summary in summaries)
        {
            foreach (WingSummary wing in summary.Wings)
                Row(text, Cells(summary, wing));
        }

        return text.ToString();
    }

    private static IEnumerable<string> Cells(FlightSummary summary, WingSummary wing)
    {
        SpeciesVariant variant = summary.Flight.Plan.Variant;
        return
        [
            summary.Flight.Insect.Name, variant.ToString().ToLowerInvariant(), wing.Name, Number(wing.FrequencyHz, 1),
            .. MeasureBound.All.Select(bound => bound.Cell(wing, variant)),
            $"{Number(wing.CamberMinPct, 1)}…{Number(wing.CamberMaxPct, 1)}", Number(wing.TipBendPpDeg, 1), Number(wing.TipLagDeg, 1),
            Number(wing.EdgeStretchP99Pct, 2), wing == summary.Main ? Number(summary.LiftOverWeight, 2) : "",
        ];
    }

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture).Replace('-', '−');

    private static void Row(StringBuilder text, IEnumerable<string> cells) => text.Append("| ").AppendJoin(" | ", cells).Append(" |\n");
}
