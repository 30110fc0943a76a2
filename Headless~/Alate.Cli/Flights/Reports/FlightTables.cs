using Spectre.Console;

namespace Alate.Cli;

/// <summary>Tables of flights on the terminal.</summary>
internal static class FlightTables
{
    /// <summary>Shows the numbers and where the files are.</summary>
    public static void ShowSummary(this Terminal terminal, FlightSummary summary, string folder, params string[] files)
    {
        FlightRecord flight = summary.Flight;
        terminal.Lines.Write(new Rule($"[bold]{Markup.Escape(flight.Insect.DisplayName)}[/]").LeftJustified());
        terminal.Lines.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{flight.Beats:0.##} beats in {flight.Seconds:0.###} s at {flight.Plan.BodySpeed:0.##} m/s; {summary.Triangles} triangles."));
        if (flight.Plan.Induced != null)
        {
            float3 induced = flight.InducedVelocity;
            terminal.Lines.WriteLine(string.Create(CultureInfo.InvariantCulture,
                $"The wings draw air along at {math.length(induced):0.###} m/s: {-induced.y:0.###} down, {-induced.z:0.###} back."));
        }

        terminal.Lines.WriteLine("The last beat:");
        terminal.Lines.Write(SummaryTable(summary));
        terminal.Lines.WriteLine(MeasureBound.Note);
        foreach (MeasureBound bound in MeasureBound.All.Where(bound => summary.Wings.Any(wing => !bound.Holds(wing, flight.Plan.Variant))))
        {
            // not wrapped
            terminal.Lines.Profile.Out.Writer.WriteLine(
                $"† {bound.Title} is outside the usual {bound.RangeOf(flight.Plan.Variant)} ({bound.Source}).");
        }
        terminal.ShowPlausibility("Beside real insects:", summary.Plausibility);
        if (summary.IsOverstretched)
            terminal.Lines.Profile.Out.Writer.WriteLine(Overstretched(summary)); // not wrapped
        terminal.ShowFiles(folder, files);
    }

    /// <summary>Shows a table of numbers with their ranges, and says what its marks mean.</summary>
    /// <param name="terminal">Where to.</param>
    /// <param name="heading">Its heading.</param>
    /// <param name="rows">The first is the head, the first column names.</param>
    /// <param name="names">First columns that are not broken into lines.</param>
    public static void ShowBounded(this Terminal terminal, string heading, IEnumerable<IReadOnlyList<string>> rows, int names = 0)
    {
        terminal.ShowTable(heading, rows, names);
        terminal.Lines.WriteLine(MeasureBound.Note);
    }

    // The last column is the range on real insects.
    private static Table SummaryTable(FlightSummary summary)
    {
        Table table = new Table().Border(TableBorder.Rounded).AddColumn("");
        foreach (WingSummary wing in summary.Wings)
            table.AddColumn(new TableColumn(summary.Wings.Count == 1 ? "" : wing.Name).RightAligned());
        table.AddColumn(new TableColumn("usual").RightAligned());
        Row(table, summary, "frequency, Hz", wing => Number(wing.FrequencyHz, 2));
        Row(table, summary, "twist, peak to peak, °", wing => Number(wing.TwistPpDeg, 1), MeasureBound.Find("twist_pp_deg"));
        Row(table, summary, "camber, % of the chord", wing => $"{Number(wing.CamberMinPct, 1)} … {Number(wing.CamberMaxPct, 1)}",
            MeasureBound.Find("camber_pct"));
        Row(table, summary, "tip bend, peak to peak, °", wing => Number(wing.TipBendPpDeg, 1));
        Row(table, summary, "tip bend, largest, °", wing => Number(wing.TipBendMaxDeg, 1), MeasureBound.Find("tip_bend_max_deg"));
        Row(table, summary, "lag of the trailing edge, °", wing => Number(wing.LagDeg, 1), MeasureBound.Find("lag_deg"));
        Row(table, summary, "lag of the tip, °", wing => Number(wing.TipLagDeg, 1));
        Row(table, summary, "edge stretch, largest, %", wing => Number(wing.EdgeStretchMaxPct, 2),
            MeasureBound.Find("edge_stretch_max_pct"));
        Row(table, summary, "edge stretch, 99th percentile, %", wing => Number(wing.EdgeStretchP99Pct, 2));
        Row(table, summary, "stiffness EI of the leading chain, N m²", wing => Scientific(wing.Stiffness.Leading));
        Row(table, summary, "stiffness EI of all chains, N m²", wing => Scientific(wing.Stiffness.Whole),
            Scientific(summary.Main.Stiffness.Usual));
        Row(table, summary, "lift over weight", Number(summary.LiftOverWeight, 2));
        Row(table, summary, "mean force right, up, ahead of the body, mN", Milli(summary.MeanForce));
        Row(table, summary, "mean moment nose down, nose right, right wing up, µN m", Milli(1e3f * summary.MeanMoment));
        Row(table, summary, "Newton iterations, mean", Number(summary.NewtonIterationsMean, 2));
        Row(table, summary, "resets", Number(summary.Resets, 0));
        Row(table, summary, "µs per substep, all wings", Number(summary.Flight.MicrosecondsPerSubstep, 1));
        return table;
    }

    private static void Row(Table table, FlightSummary summary, string name, Func<WingSummary, string> value, MeasureBound bound)
    {
        InsectVariant variant = summary.Flight.Plan.Variant;
        Row(table, summary, name, wing => bound.Marked(value(wing), wing, variant), bound.RangeOf(variant));
    }

    private static void Row(Table table, FlightSummary summary, string name, Func<WingSummary, string> value, string usual = "")
    {
        string[] cells = new string[2 + summary.Wings.Count];
        (cells[0], cells[^1]) = (name, usual);
        for (int k = 0; k < summary.Wings.Count; k++)
            cells[k + 1] = value(summary.Wings[k]);
        table.AddRow(cells);
    }

    private static void Row(Table table, FlightSummary summary, string name, string value) =>
        Row(table, summary, name, wing => wing == summary.Main ? value : "");

    // One line: which wing, how much, and what to change.
    private static string Overstretched(FlightSummary summary)
    {
        WingSummary worst = summary.Overstretched;
        return string.Create(
            CultureInfo.InvariantCulture,
            $"The {worst.Name} is driven outside what it bears: an edge stretches by {worst.EdgeStretchMaxPct:0} %, "
            + $"one in a hundred by {worst.EdgeStretchP99Pct:0} % (25 and 8 are bearable). "
            + $"Lower the wind or the speed, or raise its elasticity.");
    }

    private static string Milli(float3 value) => $"{Number(1e3 * value.x, 2)}, {Number(1e3 * value.y, 2)}, {Number(1e3 * value.z, 2)}";

    private static string Scientific(double value) => value.ToString("0.0e-0", CultureInfo.InvariantCulture);

    private static string Number(double value, int digits) => value.ToString("F" + digits, CultureInfo.InvariantCulture);
}
