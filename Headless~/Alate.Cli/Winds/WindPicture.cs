using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using Alate.Cli.Pictures;
using Unity.Mathematics;

namespace Alate.Cli.Winds;

/// <summary>wind.svg: stretch over the speed of the wind, a chart for each species, today's model and version 0.1.</summary>
internal static class WindPicture
{
    private const string k_Bound = "#7a7364";

    /// <summary>The whole picture.</summary>
    public static string Draw(IReadOnlyList<SpeciesWinds> species, bool inGusts)
    {
        var sheet = new ChartSheet(
            inGusts ? "What gusts do to wings" : "What wind does to wings",
            $"Stretch of the edges, %, over the speed of {(inGusts ? "gusts" : "a steady wind")}, m/s, on top of the insect's own; the worst of 26 directions.");
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        legend.Add("largest", ChartSheet.Ink, CurveLook.Discs);
        legend.Add("99th percentile", ChartSheet.Ink, CurveLook.Thin);
        legend.Add("largest, version 0.1", ChartSheet.Ink, CurveLook.Squares);
        legend.Add("limit of the largest", k_Bound, CurveLook.Dotted);
        legend.NextLine();
        legend.AddWings(species.SelectMany(one => one.Wings.Select((_, kind) => (one.Wings.Count, kind))));
        for (int k = 0; k < species.Count; k++)
            Draw(sheet, k, species[k]);
        return sheet.Finish(species.Count, inGusts ? "Stretch of wings over the speed of gusts" : "Stretch of wings over the speed of wind");
    }

    private static void Draw(ChartSheet sheet, int index, SpeciesWinds species)
    {
        List<double> speeds = species.Wings[0].Now.Select(point => point.Speed).ToList();
        double most = speeds[^1] > 0.0 ? speeds[^1] : 1.0, high = 2.0 * WindLimit.MostOf(species.Plan.Variant);
        var across = new ChartAxis(0.0, most, false, speeds);
        var up = new ChartAxis(0.0, high, false, Enumerable.Range(0, 7).Select(k => Math.Round(k * high / 6.0, 1)).ToList());
        string name = ChartSheet.Title(species.DisplayName, species.Plan.Variant) + (species.SpeedShare < 1.0 ? ", in water" : "");
        PointChart chart = sheet.Chart(index, name, across, up);
        List<WindLimit> limits = Limits(species, most);
        DrawLimits(chart, limits);
        for (int kind = 0; kind < species.Wings.Count; kind++)
        {
            WingWinds wing = species.Wings[kind];
            string colour = ChartSheet.Colours[kind % ChartSheet.Colours.Count];
            chart.Draw(Curve(wing.Before, point => point.StretchMaxPct, colour, CurveLook.Squares));
            chart.Draw(Curve(wing.Now, point => point.StretchP99Pct, colour, CurveLook.Thin));
            chart.Draw(Curve(wing.Now, point => point.StretchMaxPct, colour, CurveLook.Discs));
        }

        foreach (WindLimit limit in limits)
            chart.Label(new ChartPoint(limit.Speed, limit.StretchPct), new float2(-4f, -4f), LineChart.Label(limit.StretchPct) + " %");
        double before = species.Wings.SelectMany(wing => wing.Before).Max(point => point.StretchMaxPct);
        if (before > high)
            chart.Label(new ChartPoint(most, high), new float2(0f, -16f), string.Create(CultureInfo.InvariantCulture, $"version 0.1: up to {before:#,0} %"));
    }

    // As far as the chart goes, at the speeds that the species meets.
    private static List<WindLimit> Limits(SpeciesWinds species, double most)
    {
        var limits = new List<WindLimit>();
        foreach (WindLimit limit in WindLimit.Of(species.Plan.Variant))
        {
            double to = Math.Min(limit.Speed * species.SpeedShare, most);
            if (limits.Count == 0 || to > limits[^1].Speed)
                limits.Add(limit with { Speed = to });
        }

        return limits;
    }

    private static void DrawLimits(PointChart chart, List<WindLimit> limits)
    {
        var steps = new List<ChartPoint>();
        double from = 0.0;
        foreach (WindLimit limit in limits)
        {
            steps.AddRange([new(from, limit.StretchPct), new(limit.Speed, limit.StretchPct)]);
            from = limit.Speed;
        }

        chart.Draw(new PointCurve(steps, k_Bound, CurveLook.Dotted));
    }

    private static PointCurve Curve(IReadOnlyList<WindPoint> points, Func<WindPoint, double> value, string colour, CurveLook look) =>
        new(points.Select(point => new ChartPoint(point.Speed, value(point))).ToList(), colour, look);
}
