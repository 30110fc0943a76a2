namespace Alate.Cli;

/// <summary>Lift and drag coefficients over the angle of attack: the paper's (Fig. 6) beside the measured sets.</summary>
internal static class CoefficientFigure
{
    private const float k_Width = 1000f, k_Height = 420f, k_ChartWidth = 480f, k_ChartHeight = 300f, k_Top = 108f;

    private static readonly (string Name, CoefficientSet Set, string Colour, CurveLook Look)[] s_Sets =
    [
        ("paper", CoefficientSet.Paper, ManualFigures.Orange, CurveLook.Dashed),
        ("Dickinson 1999", CoefficientSet.Dickinson1999, ManualFigures.Blue, CurveLook.Plain),
        ("dragonfly", CoefficientSet.Dragonfly, ManualFigures.Green, CurveLook.Dotted),
        ("flat plate", CoefficientSet.FlatPlate, ManualFigures.Grey, CurveLook.Thin),
    ];

    /// <summary>Draws both charts, SVG.</summary>
    public static string Draw()
    {
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "Lift and drag of a wing's section", look: "b");
        page.Text(
            ChartSheet.Edge, 60f, 13f, "Across the angle of attack in degrees. The dragonfly's lift is that of Dickinson.", look: "t");
        var legend = new ChartLegend(page, 86f);
        foreach ((string name, _, string colour, CurveLook look) in s_Sets)
            legend.Add(name, colour, look);
        Chart(page, 0, "lift coefficient", (lift, _) => lift);
        Chart(page, 1, "drag coefficient", (_, drag) => drag);
        return page.Finish(k_Width, k_Height, "Lift and drag coefficients over the angle of attack");
    }

    private static void Chart(SvgPage page, int column, string title, Func<float, float, double> of)
    {
        List<ChartPoint>[] curves = [.. s_Sets.Select(set => ManualFigures.Curve(90, 90, degrees =>
        {
            double angle = Math.PI / 180 * degrees;
            Coefficients.At(set.Set, (float)Math.Sin(angle), (float)Math.Cos(angle), out float lift, out float drag);
            return of(lift, drag);
        }))];
        var chart = new PointChart(page, title, new ChartAxis(0, 90, false, [0, 15, 30, 45, 60, 75, 90]),
            ChartAxis.Linear(curves.SelectMany(curve => curve).Select(point => point.Y)), 12f + column * (k_ChartWidth + 10f), k_Top,
            new float2(k_ChartWidth, k_ChartHeight));
        for (int k = 0; k < curves.Length; k++)
            chart.Draw(new PointCurve(curves[k], s_Sets[k].Colour, s_Sets[k].Look));
    }
}
