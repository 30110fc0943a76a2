using System.Text.Json;

namespace Alate.Cli;

/// <summary>The report of all comparisons as JSON.</summary>
internal static class ValidationJson
{
    private static readonly JsonSerializerOptions s_Json = new() { WriteIndented = true };

    /// <summary>All rows and curves.</summary>
    public static string Write(IReadOnlyList<ValidationRow> rows, IReadOnlyList<ValidationCurve> curves) => JsonSerializer.Serialize(
        new
        {
            substeps = DragonflyRows.Substeps,
            fine_substeps = DragonflyRows.FineSubsteps,
            counted = rows.Count(row => row.IsCounted),
            counted_inside = rows.Count(row => row.IsCounted && row.IsInside),
            rows = rows.Select(row => new
            {
                table = row.Table.ToString().ToLowerInvariant(),
                record = row.Record,
                quantity = row.Quantity,
                variant = row.Variant,
                counted = row.IsCounted,
                reason = row.Reason,
                published = row.Published,
                low = Finite(row.Low),
                high = Finite(row.High),
                band = row.Band,
                source = row.Source,
                ours = Finite(row.Ours),
                at_twice_the_substeps = Finite(row.Fine),
                change = Finite(row.Change),
                converged = row.IsConverged,
                verdict = row.Verdict,
                inside = row.IsInside,
                distance = Finite(row.Distance),
                experiments = row.Experiments.Select(one => new { changed = one.Changed, value = Finite(one.Value) }),
            }),
            curves = curves.Select(curve => new
            {
                key = curve.Key,
                title = curve.Title,
                published = curve.Published,
                measured = curve.Measured?.Select(Finite),
                ours = curve.Ours.ToDictionary(one => one.Name, one => one.Values),
            }),
        },
        s_Json) + "\n";

    private static double? Finite(double value) => double.IsFinite(value) ? Math.Round(value, 6) : null;
}
