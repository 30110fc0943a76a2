namespace Alate.Cli;

/// <summary>wake-accuracy.svg: error over cost, a chart for each wake, over steps and over panels.</summary>
internal static class WakeAccuracyPicture
{
    /// <summary>The whole picture.</summary>
    public static string Draw(IReadOnlyList<WakeAccuracy> wakes)
    {
        var sheet = new ChartSheet("How far wakes are off, and what they cost",
            "Distance of the mean force from that of a much finer wake, % of the weight, over the time, default = 1.");
        string steps = ChartSheet.Colours[0], panels = ChartSheet.Colours[1];
        var legend = new ChartLegend(sheet.Page, sheet.LegendTop);
        legend.Add($"steps of a beat: {List(wakes[0].OverSteps, point => point.Steps)}", steps, CurveLook.Discs);
        legend.Add($"panels along the span: {List(wakes[0].OverPanels, point => point.Panels)}", panels, CurveLook.Squares);
        legend.AddRing("default", ChartSheet.Ink);
        // A wake that is not off at all has no place on a logarithmic axis.
        const double k_Least = 1e-3;
        List<WakePoint> all = [.. wakes.SelectMany(wake => wake.OverSteps.Concat(wake.OverPanels))];
        var across = ChartAxis.Logarithmic(all.Min(point => point.Cost), all.Max(point => point.Cost));
        var up = ChartAxis.Logarithmic(Math.Max(all.Min(point => point.ErrorPct), k_Least), all.Max(point => point.ErrorPct));
        for (int k = 0; k < wakes.Count; k++)
        {
            PointChart chart = sheet.Chart(k, wakes[k].Title, across, up);
            chart.Draw(new PointCurve(wakes[k].OverSteps.ConvertAll(Place), steps, CurveLook.Discs));
            chart.Draw(new PointCurve(wakes[k].OverPanels.ConvertAll(Place), panels, CurveLook.Squares));
            var usual = new WakePlan();
            chart.Ring(Place(wakes[k].OverSteps.Find(point => point.Steps == usual.StepsPerBeat)), steps);
            chart.Ring(Place(wakes[k].OverPanels.Find(point => point.Panels == usual.SpanPanels)), panels);
        }

        return sheet.Finish(wakes.Count, "Error of the mean force over the cost of a wake");
    }

    /// <summary>The table of the documentation's page.</summary>
    public static IEnumerable<IReadOnlyList<string>> Table(IReadOnlyList<WakeAccuracy> wakes)
    {
        yield return
        [
            "off by, % of the weight", .. wakes[0].OverSteps.Select(point => $"{point.Steps} steps"),
            .. wakes[0].OverPanels.Select(point => $"{point.Panels} panels"), "default, against finer in both",
        ];
        foreach (WakeAccuracy wake in wakes)
        {
            yield return
            [
                wake.Title, .. wake.OverSteps.Concat(wake.OverPanels).Select(point => point.ErrorPct).Append(wake.DefaultErrorPct)
                    .Select(error => error.ToString("0.0", CultureInfo.InvariantCulture)),
            ];
        }
    }

    private static string List(IEnumerable<WakePoint> points, Func<WakePoint, int> number) => string.Join(", ", points.Select(number));

    private static ChartPoint Place(WakePoint point) => new(point.Cost, point.ErrorPct);
}
