using System.Text.Json;

namespace Alate.Cli;

/// <summary>The report of all comparisons, as a page, as JSON and as charts.</summary>
internal static class ValidationPage
{
    // Words of the titles of the front page's rows.
    private static readonly string[][] s_Selected =
    [
        ["flight 1, rigid wings: lift"], ["flight 2, rigid wings: lift"], ["flight 3, rigid wings: lift"],
        ["flight 2, rigid wings: thrust"],
        ["tethered", "no induced flow: mean of the vertical"], ["tethered", "m/s: mean of the vertical"], ["tethered",
            "m/s: correlation of the vertical"],
        ["monarch, free flight: power"], ["monarch, free flight: upstroke's share of the weight"], ["level", "largest twist"],
    ];

    private static readonly JsonSerializerOptions s_Json = new() { WriteIndented = true };

    /// <summary>The page, Markdown; rows that do not agree stand first.</summary>
    /// <param name="rows">The comparisons.</param>
    /// <param name="curves">What the charts show.</param>
    /// <param name="picture">Path of the charts from the page.</param>
    public static string Markdown(IReadOnlyList<ValidationRow> rows, IReadOnlyList<ValidationCurve> curves, string picture)
    {
        List<ValidationRow> outside = rows.Where(row => !row.IsInside).ToList(), inside = rows.Where(row => row.IsInside).ToList();
        var refined = rows.Where(row => !double.IsNaN(row.Fine)).ToList();
        var page = new StringBuilder("# Validation\n\nJudge how far the model can be trusted: it stands here beside measured and published "
            + "flights, written by [`validate`](command-line.md#validate), at ");
        page.Append(CultureInfo.InvariantCulture, $"{DragonflyRows.Substeps} substeps of a beat and at "
            + $"{DragonflyRows.FineSubsteps}; the last columns say how far both are apart, and the verdict is that of the finer one. ");
        page.Append(CultureInfo.InvariantCulture, $"{inside.Count} of {rows.Count} rows agree; "
            + $"{refined.Count(row => row.IsConverged)} of {refined.Count} are converged within {100 * ValidationRow.Converged:0} %.\n\n");
        page.Append("The dragonfly's rows are flown with the catalogue's wings at the published lengths; the density of the air makes up "
            + "for the difference in area. Added mass goes with the square of the chord and is too large by as much, 7 to 10 % for the "
            + "tethered insect. Rows *with the drag of a dragonfly's wing* have the coefficients [Dragonfly](wing-preset.md#options), the "
            + "others those of the presets. Rows *in its own wake* have no induced flow but a free [wake](wake.md) by strips, in 24 steps "
            + "of a beat and ten strips, and in twice as many of both beside twice the substeps. Their kinematics are "
            + "[examples of the manual](kinematics.md#examples), digitised from plots by J. Pecquet.\n\nStrips are wings of "
            + "[measured stiffness](wing-skeleton.md#measured-stiffness) without air; they are compared with beams.\n\n");
        page.Append("## Outside\n\n").Append(MarkdownTable.Write(Table(outside, true)));
        page.Append("\n## Inside\n\n").Append(MarkdownTable.Write(Table(inside, false)));
        page.Append("\n## Over the beat\n\nThe tethered dragonfly with the induced flow of momentum theory, but for the curve that says "
            + "otherwise. `validate --data DIR` draws curves of your own in place of the published ones.\n\n");
        page.Append(MarkdownTable.Write(curves.Select(curve => new[] { curve.Title, curve.Published }).Prepend(["curve", "published"])))
            .Append('\n');
        page.Append($"![Curves of the tethered dragonfly over the beat]({picture})\n");
        return page.ToString();
    }

    /// <summary>All rows as JSON.</summary>
    public static string Json(IReadOnlyList<ValidationRow> rows, IReadOnlyList<ValidationCurve> curves) => JsonSerializer.Serialize(
        new
        {
            substeps = DragonflyRows.Substeps,
            fine_substeps = DragonflyRows.FineSubsteps,
            rows = rows.Select(row => new
            {
                title = row.Title,
                measured = row.Measured,
                low = Finite(row.Low),
                high = Finite(row.High),
                source = row.Source,
                ours = Finite(row.Ours),
                at_twice_the_substeps = Finite(row.Fine),
                change = Finite(row.Change),
                converged = row.IsConverged,
                verdict = row.Verdict,
                inside = row.IsInside,
                distance = Finite(row.Distance),
                cause = row.IsInside ? null : row.Cause,
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

    /// <summary>The rows that the package's front page shows, Markdown.</summary>
    public static string Selection(IReadOnlyList<ValidationRow> rows) =>
        $"{rows.Count(row => row.IsInside)} of the {rows.Count} comparisons of [Validation](Documentation~/validation.md) agree. Some of "
        + "both kinds:\n\n"
        + MarkdownTable.Write(s_Selected
        .SelectMany(words => rows.Where(row => words.All(row.Title.Contains)))
        .Select(row => new[] { row.Title, $"{row.Measured} ({row.Source})", Text($"{row.Value:0.00}"), row.Verdict })
        .Prepend(["", "measured", "here", "verdict"]));

    private static IEnumerable<string[]> Table(IReadOnlyList<ValidationRow> rows, bool causes)
    {
        string[] head = ["", "measured", "source", "ours", "verdict", "at twice the substeps", "change"];
        yield return causes ? [.. head, "believed cause"] : head;
        foreach (ValidationRow row in rows)
        {
            bool refined = !double.IsNaN(row.Fine);
            string[] cells = [row.Title, row.Measured, row.Source, Text($"{row.Ours:0.00}"), row.Verdict,
                refined ? Text($"{row.Fine:0.00}") : "–", refined ? Text($"{100 * row.Change:0.0} %") : "–"];
            yield return causes ? [.. cells, row.Cause] : cells;
        }
    }

    private static double? Finite(double value) => double.IsFinite(value) ? Math.Round(value, 6) : null;

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
