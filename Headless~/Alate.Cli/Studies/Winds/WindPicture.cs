namespace Alate.Cli;

/// <summary>wind.svg: stretch over the speed of the wind, a chart for each species, today's model and version 0.1.</summary>
internal static class WindPicture
{
    private const int k_Ticks = 6;
    private const string k_Bound = "#7a7364";

    /// <summary>The whole picture.</summary>
    public static string Draw(IReadOnlyList<SpeciesWinds> species, bool inGusts)
    {
        InsectVariant variant = species[0].Plan.Variant;
        var sheet = new ChartSheet(
            KnownSpecies.Titled(inGusts ? "What gusts do to wings" : "What wind does to wings", variant),
            $"Stretch of the edges, %, over the speed of {(inGusts ? "gusts" : "a steady wind")}, m/s, on top of the insect's own; the "
            + "worst of 26 directions.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        legend.Add("largest", ChartSheet.Ink, CurveLook.Discs);
        legend.Add("99th percentile", ChartSheet.Ink, CurveLook.Thin);
        legend.Add("largest, version 0.1", ChartSheet.Ink, CurveLook.Squares);
        legend.Add($"limit of the largest: {string.Join(", ", WindLimit.Of(variant).Select(limit => LineChart.Label(limit.StretchPct)))} %",
            k_Bound, CurveLook.Dotted);
        legend.NextLine();
        legend.AddWings(species.SelectMany(one => one.Wings.Select((_, kind) => (one.Wings.Count, kind))));
        for (int k = 0; k < species.Count; k++)
            Draw(sheet, k, species[k]);
        return sheet.Finish(
            species.Count, inGusts ? "Stretch of wings over the speed of gusts" : "Stretch of wings over the speed of wind");
    }

    private static void Draw(ChartSheet sheet, int index, SpeciesWinds species)
    {
        var speeds = species.Wings[0].Now.Select(point => point.Speed).ToList();
        double most = speeds[^1] > 0.0 ? speeds[^1] : 1.0, tick = species.Plan.Variant == InsectVariant.Expressive ? 10.0 : 5.0,
            high = k_Ticks * tick;
        var across = new ChartAxis(0.0, most, false, speeds);
        var up = new ChartAxis(0.0, high, false, Enumerable.Range(0, k_Ticks + 1).Select(k => k * tick).ToList());
        string name = species.DisplayName + (species.SpeedShare < 1.0 ? ", in water" : "");
        PointChart chart = sheet.Chart(index, name, across, up);
        DrawLimits(chart, species, most);
        for (int kind = 0; kind < species.Wings.Count; kind++)
        {
            WingWinds wing = species.Wings[kind];
            string colour = ChartSheet.Colours[kind % ChartSheet.Colours.Count];
            chart.Draw(Curve(wing.Before, point => point.StretchMaxPct, colour, CurveLook.Squares));
            chart.Draw(Curve(wing.Now, point => point.StretchP99Pct, colour, CurveLook.Thin));
            chart.Draw(Curve(wing.Now, point => point.StretchMaxPct, colour, CurveLook.Discs));
        }

        double before = species.Wings.SelectMany(wing => wing.Before).Max(point => point.StretchMaxPct);
        if (before > high)
            chart.Remark(string.Create(CultureInfo.InvariantCulture, $"0.1: up to {before:#,0} %"));
    }

    // A step for each limit, as far as the chart goes.
    private static void DrawLimits(PointChart chart, SpeciesWinds species, double most)
    {
        var steps = new List<ChartPoint>();
        double from = 0.0;
        foreach (WindLimit limit in WindLimit.Of(species.Plan.Variant))
        {
            double to = Math.Min(limit.Speed * species.SpeedShare, most);
            if (to <= from)
                break;
            steps.AddRange([new(from, limit.StretchPct), new(to, limit.StretchPct)]);
            from = to;
        }

        chart.Draw(new PointCurve(steps, k_Bound, CurveLook.Dotted));
    }

    private static PointCurve Curve(IReadOnlyList<WindPoint> points, Func<WindPoint, double> value, string colour, CurveLook look) =>
        new(points.Select(point => new ChartPoint(point.Speed, value(point))).ToList(), colour, look);
}
