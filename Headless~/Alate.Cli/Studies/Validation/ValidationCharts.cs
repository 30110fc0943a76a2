namespace Alate.Cli;

/// <summary>The curves of all comparisons over the beat, SVG.</summary>
internal static class ValidationCharts
{
    private const float k_Width = 1000f, k_ChartWidth = 480f, k_ChartHeight = 250f, k_Top = 108f;

    // Looks differ without their colours.
    private static readonly (string Name, string Colour, CurveLook Look)[] s_Looks =
    [
        ("rigid", "#0b5fa5", CurveLook.Plain), ("flexible", "#c2410c", CurveLook.Dashed), ("no induced flow", "#6b6455", CurveLook.Dotted),
        ("blade elements", "#15803d", CurveLook.Thin),
    ];

    /// <summary>Draws them.</summary>
    public static string Draw(IReadOnlyList<ValidationCurve> curves)
    {
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "Tethered dragonfly over the beat", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f,
            "Across t/T, as in the published series. With the induced flow of momentum theory but where the name says otherwise.",
            look: "t");
        var legend = new ChartLegend(page, 86f);
        foreach ((string name, string colour, CurveLook look) in s_Looks.Where(
            one => curves.Any(curve => curve.Ours.Any(line => line.Name == one.Name))))
        {
            legend.Add(name + (name == "blade elements" ? ", apart from the model" : ""), colour, look);
        }
        if (curves.Any(curve => curve.Measured != null))
            legend.Add("published, or of --data", ChartSheet.Ink, CurveLook.Discs);
        for (int k = 0; k < curves.Count; k++)
            Draw(page, curves[k], k);
        return page.Finish(k_Width, k_Top + (curves.Count + 1) / 2 * k_ChartHeight + 12f, "Curves of the tethered dragonfly over the beat");
    }

    private static void Draw(SvgPage page, ValidationCurve curve, int index)
    {
        var up = ChartAxis.Linear(curve.Ours.SelectMany(one => one.Values).Concat(curve.Measured ?? []).Where(double.IsFinite));
        var across = new ChartAxis(0, 1, false, [0, 0.2, 0.4, 0.6, 0.8, 1]);
        var chart = new PointChart(page, curve.Title, across, up, 12f + index % 2 * (k_ChartWidth + 10f), k_Top + index / 2 * k_ChartHeight,
            new float2(k_ChartWidth, k_ChartHeight));
        foreach ((string name, double[] values) in curve.Ours)
        {
            (_, string colour, CurveLook look) = s_Looks.FirstOrDefault(one => one.Name == name, s_Looks[0]);
            chart.Draw(new PointCurve(Closed(values), colour, look));
        }

        foreach (List<ChartPoint> piece in Pieces(curve.Measured ?? []))
            chart.Draw(new PointCurve(piece, ChartSheet.Ink, CurveLook.Discs));
    }

    // Between the holes.
    private static IEnumerable<List<ChartPoint>> Pieces(double[] values)
    {
        var piece = new List<ChartPoint>();
        foreach (ChartPoint point in values.Length > 0 ? Closed(values) : [])
        {
            if (double.IsFinite(point.Y))
            {
                piece.Add(point);
            }
            else if (piece.Count > 0)
            {
                yield return piece;
                piece = [];
            }
        }

        if (piece.Count > 0)
            yield return piece;
    }

    // The beat repeats.
    private static List<ChartPoint> Closed(double[] values) =>
        Enumerable.Range(0, values.Length + 1).Select(n => new ChartPoint((double)n / values.Length, values[n % values.Length])).ToList();
}
