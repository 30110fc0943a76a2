using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;
using Alate.Cli.Pictures;

namespace Alate.Cli.Figures;

/// <summary>What veins do to a wing: the monarch's twist and camber over the beat with all chains alike, with thick veins in front, and with thick veins behind.</summary>
internal static class VeinFigure
{
    private const float k_Width = 1000f, k_Height = 330f, k_ChartWidth = 480f, k_ChartHeight = 230f, k_Top = 84f;
    private const int k_Substeps = 100;
    private static readonly string[] s_Colours = ["#6b6459", "#0b5fa5", "#c2410c"];

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
        page.Text(26f, 38f, 22f, "Veins of a monarch's wing over the beat", look: "b");
        page.Text(26f, 60f, 13f, "Grey: chains all alike. Blue: thick veins in front. Red: thick veins behind. The mean stiffness is the same.", look: "t");
        Chart(page, wings, 0, "twist, °", (wing, frame) => 180 / Math.PI * wing.Measurement.Twist(frame.Positions));
        Chart(page, wings, 1, "camber, % of the chord", (wing, frame) => 100 * wing.Measurement.Camber(frame.Positions));
        return page.Finish(k_Width, k_Height, "Twist and camber of a monarch's wing with and without veins");
    }

    private static void Chart(SvgPage page, List<RecordedWing> wings, int column, string title, Func<RecordedWing, BeatFrame, double> of)
    {
        var curves = wings.Select((wing, k) => new ChartCurve(wing.Beat.OrderBy(Place).Select(frame => of(wing, frame)).ToArray(), s_Colours[k], false)).ToList();
        var turns = Enumerable.Range(0, k_Substeps).Select(n => (double)n / k_Substeps).ToList();
        new LineChart(turns, false, 12f + column * (k_ChartWidth + 10f), k_Top, k_ChartWidth, k_ChartHeight).Draw(page, title, curves);
    }

    // A frame a substep; that of the beat's end is its start.
    private static int Place(BeatFrame frame) => (int)Math.Round(k_Substeps * frame.Phase / (2 * Math.PI)) % k_Substeps;
}
