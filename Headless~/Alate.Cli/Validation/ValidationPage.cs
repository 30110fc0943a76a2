using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using System.Text.Json;
using Alate.Cli.Figures;
using Alate.Cli.Pictures;

namespace Alate.Cli.Validation;

/// <summary>The report of all comparisons, as a page, as JSON and as charts.</summary>
internal static class ValidationPage
{
    private const float k_Width = 1000f, k_ChartWidth = 480f, k_ChartHeight = 230f, k_Top = 84f;
    private static readonly string[] s_Colours = ["#0b5fa5", "#c2410c", "#6d28d9"];
    private static readonly JsonSerializerOptions s_Json = new() { WriteIndented = true };

    /// <summary>The page, Markdown; rows that do not agree stand first.</summary>
    /// <param name="rows">The comparisons.</param>
    /// <param name="picture">Path of the charts from the page.</param>
    public static string Markdown(IReadOnlyList<ValidationRow> rows, string picture)
    {
        List<ValidationRow> outside = rows.Where(row => !row.IsInside).ToList(), inside = rows.Where(row => row.IsInside).ToList();
        var refined = rows.Where(row => !double.IsNaN(row.Fine)).ToList();
        var page = new StringBuilder("# Validation\n\nWritten by `validate`; see [the command line](command-line.md#validate). The model beside measured and published flights, at ");
        page.Append(CultureInfo.InvariantCulture, $"{DragonflyRows.Substeps} substeps of a beat and at {DragonflyRows.FineSubsteps}; the last columns say how far both are apart. A dash is a free flight, whose substeps are those of its trim table. ");
        page.Append(CultureInfo.InvariantCulture, $"{inside.Count} of {rows.Count} rows agree; {refined.Count(row => row.Change <= ValidationRow.Converged)} of {refined.Count} are converged within 3 %.\n\n");
        page.Append("The dragonfly's rows are flown with the catalogue's wings at the published lengths; the density of the air makes up for the difference in area. Their kinematics are [examples of the manual](kinematics.md#examples), digitised from plots by J. Pecquet.\n\n");
        page.Append("## Outside\n\n").Append(MarkdownTable.Write(Table(outside, true)));
        page.Append("\n## Inside\n\n").Append(MarkdownTable.Write(Table(inside, false)));
        page.Append("\n## Over the beat\n\nThe tethered dragonfly with the induced flow of momentum theory, but for the curve that says otherwise. The published vertical force is computed by its authors, not measured. `validate --data DIR` draws curves of your own in their place.\n\n");
        page.Append($"![Curves of the tethered dragonfly over the beat]({picture})\n");
        page.Append("\n## Not compared yet\n\nA cantilever and a flapping plate for the structure alone, stiffness in newtons times square metres, and added mass.\n");
        return page.ToString();
    }

    /// <summary>All rows as JSON.</summary>
    public static string Json(IReadOnlyList<ValidationRow> rows, IReadOnlyList<ValidationCurve> curves) => JsonSerializer.Serialize(
        new
        {
            rows = rows.Select(row => new
            {
                title = row.Title,
                measured = row.Measured,
                low = Finite(row.Low),
                high = Finite(row.High),
                source = row.Source,
                ours = Finite(row.Ours),
                at_480_substeps = Finite(row.Fine),
                change = Finite(row.Change),
                inside = row.IsInside,
                distance = row.Distance,
                cause = row.IsInside ? null : row.Cause,
            }),
            curves = curves.Select(curve => new { key = curve.Key, title = curve.Title, measured = curve.Measured, ours = curve.Ours.ToDictionary(one => one.Name, one => one.Values) }),
        },
        s_Json) + "\n";

    /// <summary>The charts, SVG.</summary>
    public static string Charts(IReadOnlyList<ValidationCurve> curves)
    {
        var page = new SvgPage();
        page.Text(26f, 38f, 22f, "Tethered dragonfly over the beat", look: "b");
        page.Text(26f, 60f, 13f, "Across t/T. Lines: the model, in the order of each title. Dashed: published, or the user's.", look: "t");
        for (int k = 0; k < curves.Count; k++)
        {
            ValidationCurve curve = curves[k];
            int count = curve.Ours[0].Values.Length;
            var lines = curve.Ours.Select((one, n) => new ChartCurve(one.Values, s_Colours[n], false)).ToList();
            if (curve.Measured != null)
                lines.Add(new ChartCurve(curve.Measured, "#3d3a34", true));
            var chart = new LineChart(Enumerable.Range(0, count).Select(n => (double)n / count).ToList(), false, 12f + k % 2 * (k_ChartWidth + 10f), k_Top + k / 2 * k_ChartHeight, k_ChartWidth, k_ChartHeight);
            chart.Draw(page, $"{curve.Title}: {string.Join(", ", curve.Ours.Select(one => one.Name))}", lines);
        }

        return page.Finish(k_Width, k_Top + (curves.Count + 1) / 2 * k_ChartHeight + 12f, "Curves of the tethered dragonfly over the beat");
    }

    private static IEnumerable<string[]> Table(IReadOnlyList<ValidationRow> rows, bool causes)
    {
        string[] head = ["", "measured", "source", "ours", "verdict", "at 480 substeps", "change"];
        yield return causes ? [.. head, "believed cause"] : head;
        foreach (ValidationRow row in rows)
        {
            string verdict = row.IsInside ? "inside" : Text($"outside by {row.Distance:0.00}");
            bool refined = !double.IsNaN(row.Fine);
            string[] cells = [row.Title, row.Measured, row.Source, Text($"{row.Ours:0.00}"), verdict, refined ? Text($"{row.Fine:0.00}") : "–", refined ? Text($"{100 * row.Change:0.0} %") : "–"];
            yield return causes ? [.. cells, row.Cause] : cells;
        }
    }

    private static double? Finite(double value) => double.IsFinite(value) ? Math.Round(value, 6) : null;

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
