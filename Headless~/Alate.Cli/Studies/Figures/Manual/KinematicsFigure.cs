namespace Alate.Cli;

/// <summary>Angles of the measured flight that the page of kinematics flies, over the beat.</summary>
internal static class KinematicsFigure
{
    private const float k_Width = 1000f, k_Height = 400f, k_ChartWidth = 480f, k_ChartHeight = 284f, k_Top = 108f;
    private const int k_Steps = 96;

    private static readonly (string Name, Func<PresetKinematics, AngleSeries> Of, string Colour, CurveLook Look)[] s_Angles =
    [
        ("flap", motion => motion.flap, ManualFigures.Blue, CurveLook.Plain),
        ("sweep", motion => motion.sweep, ManualFigures.Grey, CurveLook.Dotted),
        ("feather, nose down", motion => motion.feather, ManualFigures.Orange, CurveLook.Dashed),
    ];

    /// <summary>The file whose motion is drawn.</summary>
    public static string Source => Path.Combine(PackageRoot.Find(), "Documentation~", "kinematics", "dragonfly-flight-1.json");

    /// <summary>Draws a chart for each wing, SVG.</summary>
    public static string Draw()
    {
        InsectDefinition dragonfly = InsectCatalogue.Find("dragonfly");
        var file = KinematicsFile.Read(Source, [.. dragonfly.Wings.Select(wing => wing.Name)], InputFiles.Instance);
        var page = new SvgPage();
        page.Text(ChartSheet.Edge, 38f, 22f, "A dragonfly's wings as they were measured", look: "b");
        page.Text(ChartSheet.Edge, 60f, 13f, "Angles about the hinge in degrees, over the beat; dragonfly-flight-1.json.", look: "t");
        var legend = new ChartLegend(page, 86f);
        foreach ((string name, _, string colour, CurveLook look) in s_Angles)
            legend.Add(name, colour, look);
        for (int kind = 0; kind < dragonfly.Wings.Count; kind++)
        {
            PresetKinematics motion = file.Wings[dragonfly.Wings[kind].Name];
            List<ChartPoint>[] curves = [.. s_Angles.Select(angle => ManualFigures.Curve(
                1.0, k_Steps, turns => angle.Of(motion).At((float)turns)))];
            var chart = new PointChart(page, dragonfly.Wings[kind].Name, new ChartAxis(0, 1, false, [0, 0.25, 0.5, 0.75, 1]),
                new ChartAxis(-90, 60, false, [-90, -60, -30, 0, 30, 60]), 12f + kind * (k_ChartWidth + 10f), k_Top,
                new float2(k_ChartWidth, k_ChartHeight));
            for (int k = 0; k < curves.Length; k++)
                chart.Draw(new PointCurve(curves[k], s_Angles[k].Colour, s_Angles[k].Look));
        }

        return page.Finish(k_Width, k_Height, "Flap, sweep and feather of a dragonfly's fore and hind wings over the beat");
    }
}
