namespace Alate.Cli;

/// <summary>The report of all comparisons as a page, and its part of the front page.</summary>
internal static class ValidationPage
{
    /// <summary>The physics by which the counted rows are flown.</summary>
    private const string k_Physics = "- **Dragonfly**: the published motion as it was filmed, on wings that do not bend besides, for it "
        + "holds how they bent; lift and drag coefficients measured on dragonflies ([Dragonfly](wing-preset.md#options)); each wing in "
        + "the free [wake](wake.md) of all by strips, 24 steps of a beat and ten strips, twice as many of both beside twice the "
        + "substeps. No induced flow besides, no added mass.\n"
        + "- **Butterflies, moth, firefly**: [free flight](flight.md) by their own wings, variant *flight*, no aid, no wind; wings "
        + "that bend and meet the air of their wakes, as the trim table has it; coefficients of the preset, rotation where the flow is "
        + "attached.\n"
        + "- **Monarch held**: the standard wings that bend, nose up by 30°, as it flies.\n";

    private const string k_Sizes = "The dragonfly's rows are flown with the catalogue's wings at the published lengths; the density of "
        + "the air makes up for the difference in area. The motions are [examples of the manual](kinematics.md#examples), of series that "
        + "J. Pecquet collected. Forces of a steady flight are known without a measurement: the weight and the drag of the body, here that "
        + "of the catalogue's body.\n";

    /// <summary>The page, Markdown; rows that do not agree stand first.</summary>
    /// <param name="rows">The comparisons.</param>
    /// <param name="curves">What the charts show.</param>
    /// <param name="picture">Path of the charts from the page.</param>
    public static string Markdown(IReadOnlyList<ValidationRow> rows, IReadOnlyList<ValidationCurve> curves, string picture)
    {
        List<ValidationRow> counted = [.. rows.Where(row => row.IsCounted)];
        var page = new StringBuilder("# Validation\n\nJudge how far the model can be trusted: it stands here beside measured and published "
            + "flights, written by [`validate`](command-line.md#validate), at ");
        page.Append(CultureInfo.InvariantCulture, $"{DragonflyRows.Substeps} substeps of a beat and at "
            + $"{DragonflyRows.FineSubsteps}; the last columns say how far both are apart, and the verdict is that of the finer one. ");
        page.Append(CultureInfo.InvariantCulture, $"{Count(counted)} rows of insects agree, one row a record and quantity. "
            + $"{counted.Count(row => row.IsConverged)} of them are converged within {100 * ValidationRow.Converged:0} "
            + $"% of the value or {100 * ValidationRow.OfBand:0} % of the band.\n\n");
        page.Append("A row counts if the published value has a band of its source: the spread between beats or animals, two sources, or "
            + "what the last printed digits leave open. *Measured* is what was measured; what others computed from a measured motion says "
            + "so.\n\n");
        page.Append("## Best physics\n\nThe counted rows are flown by the best that the package has:\n\n").Append(k_Physics).Append('\n')
            .Append(k_Sizes);
        page.Append("\n## Insects outside\n\n").Append(MarkdownTable.Write(Table(counted.Where(row => !row.IsInside))));
        page.Append("\nWhat moves them: the same value after one change, computed by the same command.\n\n")
            .Append(MarkdownTable.Write(Experiments(counted.Where(row => !row.IsInside))));
        page.Append("\n## Insects inside\n\n").Append(MarkdownTable.Write(Table(counted.Where(row => row.IsInside))));
        Fold(page, "Not counted: no band of a source, or a row that says nothing", MarkdownTable.Write(
            Reasons(rows.Where(row => row.Table == ValidationTable.Insects && row.Variant == null && row.Reason != null))));
        Fold(page, "Other variants of the same flights, not counted", MarkdownTable.Write(
            Table(rows.Where(row => row.Table == ValidationTable.Insects && row.Variant != null))));
        Section(page, rows, ValidationTable.Wakes, "Wakes beside theory", "Lattices of panels or strips that shed a [free wake](wake.md), "
            + "beside closed forms of thin wings, the wing of Dickinson, Lehmann and Sane 1999, the computed loads of a hovering fruit "
            + "fly, and a stiff wing that flaps in a stream at up to 30° to the air, where panels know no separation; the second value is "
            + "that of a finer lattice with shorter steps. Theory has no spread.");
        Section(page, rows, ValidationTable.Strips, "Strips beside beam theory", "Wings of "
            + "[measured stiffness](wing-skeleton.md#measured-stiffness) without air, which are strips. Theory has no spread.");
        Section(page, rows, ValidationTable.Data, "Your curves", "Curves of `--data` beside the last curve of the model.");
        page.Append("\n## Over the beat\n\nThe tethered dragonfly with the induced flow of momentum theory, but for the curve that says "
            + "otherwise. `validate --data DIR` draws curves of your own in place of the published ones.\n\n");
        page.Append(MarkdownTable.Write(curves.Select(curve => new[] { curve.Title, curve.Published }).Prepend(["curve", "published"])))
            .Append('\n');
        page.Append($"![Curves of the tethered dragonfly over the beat]({picture})\n");
        return page.ToString();
    }

    /// <summary>The rows that the package's front page shows, Markdown.</summary>
    public static string Selection(IReadOnlyList<ValidationRow> rows)
    {
        List<ValidationRow> counted = [.. rows.Where(row => row.IsCounted)];
        return $"{Count(counted)} comparisons of insects with measured and published flights agree. "
            + $"{Of(rows, ValidationTable.Wakes).Count} rows of wakes and {Of(rows, ValidationTable.Strips).Count} of strips beside theory "
            + "are not counted among them: [Validation](Documentation~/validation.md).\n\n"
            + MarkdownTable.Write(counted.Select(row => new[]
            {
                row.Title, row.Published, Band(row), row.Source, Number(row.Value), row.Verdict,
            }).Prepend(["", "published", "band", "source", "here", "verdict"]));
    }

    private static string Count(IReadOnlyList<ValidationRow> rows) => $"{rows.Count(row => row.IsInside)} of {rows.Count}";

    private static List<ValidationRow> Of(IEnumerable<ValidationRow> rows, ValidationTable table) =>
        [.. rows.Where(row => row.Table == table)];

    private static void Section(
        StringBuilder page, IEnumerable<ValidationRow> rows, ValidationTable table, string title, string text)
    {
        List<ValidationRow> here = Of(rows, table);
        if (here.Count > 0)
        {
            page.Append($"\n## {title}\n\n{text} The tolerance is ours. {Count(here)} lie in it, and none is counted above.\n\n")
                .Append(MarkdownTable.Write(Theory(here.OrderBy(row => row.IsInside))));
        }
    }

    private static void Fold(StringBuilder page, string title, string table) =>
        page.Append($"\n<details>\n<summary>{title}</summary>\n\n{table}\n</details>\n");

    private static IEnumerable<string[]> Table(IEnumerable<ValidationRow> rows) => rows
        .Select(row => new[]
        {
            row.Title, row.Published, Band(row), row.Band, row.Source, Number(row.Ours), row.Verdict, Fine(row), Change(row),
        })
        .Prepend(["", "published", "band", "from", "source", "ours", "verdict", "finer", "change"]);

    private static IEnumerable<string[]> Theory(IEnumerable<ValidationRow> rows) => rows
        .Select(row => new[]
        {
            row.Title, row.Published, Band(row), row.Source, Number(row.Ours), Fine(row), row.Verdict,
        })
        .Prepend(["", "published", "tolerance", "source", "ours", "finer", "verdict"]);

    private static IEnumerable<string[]> Reasons(IEnumerable<ValidationRow> rows) => rows
        .Select(row => new[] { row.Title, row.Published, row.Source, Number(row.Ours), Fine(row), Change(row), row.Reason })
        .Prepend(["", "published", "source", "ours", "finer", "change", "why it does not count"]);

    private static IEnumerable<string[]> Experiments(IEnumerable<ValidationRow> rows) => rows
        .SelectMany(row => row.Experiments.Select(one => new[]
        {
            row.Title, one.Changed, Number(row.Value), Number(one.Value), row.Contains(one.Value) ? "inside" : "outside",
        }))
        .Prepend(["", "changed", "before", "after", "then"]);

    private static string Band(ValidationRow row) => !row.HasBand ? "–"
        : double.IsInfinity(row.High) ? "above " + Number(row.Low)
        : double.IsInfinity(row.Low) ? "below " + Number(row.High) : $"{Number(row.Low)} to {Number(row.High)}";

    private static string Fine(ValidationRow row) => double.IsNaN(row.Fine) ? "–" : Number(row.Fine);

    private static string Change(ValidationRow row) => double.IsNaN(row.Fine) ? "–" : Text($"{100 * row.Change:0.0} %");

    private static string Number(double value) => Text($"{value:0.00}");

    private static string Text(FormattableString text) => text.ToString(CultureInfo.InvariantCulture).Replace('-', '−');
}
