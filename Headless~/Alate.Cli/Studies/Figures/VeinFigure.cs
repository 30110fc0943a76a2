namespace Alate.Cli;

/// <summary>
/// Effect of veins on a wing: the monarch's twist and camber over the beat with all chains alike, with thick veins in front, and with thick
/// veins behind.
/// </summary>
internal static class VeinFigure
{
    private const float k_Width = 1000f, k_Height = 366f, k_ChartWidth = 480f, k_ChartHeight = 250f, k_Top = 108f;
    private const int k_Substeps = 100;

    // Looks differ without their colours.
    private static readonly (string Colour, CurveLook Look)[] s_Looks =
        [("#6b6455", CurveLook.Dotted), ("#0b5fa5", CurveLook.Plain), ("#c2410c", CurveLook.Dashed)];

    /// <summary>Widths of the veins at the root of the five chains, from the leading edge on; at the tip they have half.</summary>
    public static IReadOnlyList<(string Name, float[] Widths)> Wings { get; } =
    [
        ("all alike", null),
        ("thick in front", [1, 0.9f, 0.6f, 0.45f, 0.4f]),
        ("thick behind", [0.4f, 0.45f, 0.6f, 0.9f, 1]),
    ];

    /// <summary>Flies the monarch with veins of some widths.</summary>
    /// <param name="widths">[chain] At the root; null where no veins are known.</param>
    /// <param name="substeps">Substeps of a beat.</param>
    public static RecordedWing Fly(float[] widths, int substeps)
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        var plan = new FlightPlan { Species = monarch.Name, Speed = FlightPlan.CruiseOf(monarch), Substeps = substeps };
        var insect = Insect.Of(plan);
        JointChain[] chains = insect.Wings[0].Skeleton.Chains;
        for (int i = 0; widths != null && i < chains.Length; i++)
            chains[i].veinWidths = [widths[i], 0.5f * widths[i]];
        using var flight = new TetheredFlight(plan, insect);
        return flight.Run(_ => { }).Wings[0];
    }

    /// <summary>Draws the charts, SVG.</summary>
    public static string Draw()
    {
        var page = new SvgPage();
        var wings = Wings.Select(wing => Fly(wing.Widths, k_Substeps)).ToList();
        page.Text(ChartSheet.Edge, 38f, 22f, "Veins of a monarch's wing over the beat", look: "b");
        page.Text(
            ChartSheet.Edge, 60f, 13f, "Across the phase from the top of the stroke, in beats. The mean stiffness is the same.", look: "t");
        var legend = new ChartLegend(page, 86f);
        for (int k = 0; k < wings.Count; k++)
            legend.Add(Wings[k].Name, s_Looks[k].Colour, s_Looks[k].Look);
        Chart(page, wings, 0, "twist, °", (wing, frame) => 180 / Math.PI * wing.Measurement.Twist(frame.Positions));
        Chart(page, wings, 1, "camber, % of the chord", (wing, frame) => 100 * wing.Measurement.Camber(frame.Positions));
        return page.Finish(k_Width, k_Height, "Twist and camber of a monarch's wing with and without veins");
    }

    private static void Chart(SvgPage page, List<RecordedWing> wings, int column, string title, Func<RecordedWing, BeatFrame, double> of)
    {
        var curves = wings.Select(wing => wing.Beat.OrderBy(Place).Select(frame => of(wing, frame)).ToArray()).ToList();
        var across = new ChartAxis(0, 1, false, [0, 0.2, 0.4, 0.6, 0.8, 1]);
        var chart = new PointChart(page, title, across, ChartAxis.Linear(curves.SelectMany(values => values)),
            12f + column * (k_ChartWidth + 10f), k_Top, new float2(k_ChartWidth, k_ChartHeight));
        for (int k = 0; k < curves.Count; k++)
        {
            double[] values = curves[k];
            chart.Draw(new PointCurve(
                Enumerable.Range(0, values.Length + 1)
                    .Select(n => new ChartPoint((double)n / values.Length, values[n % values.Length])).ToList(),
                s_Looks[k].Colour, s_Looks[k].Look));
        }
    }

    // A frame a substep; that of the beat's end is its start.
    private static int Place(BeatFrame frame) => (int)Math.Round(k_Substeps * frame.Phase / (2 * Math.PI)) % k_Substeps;
}
