using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using static Alate.Tests.Drawing.SvgElements;

namespace Alate.Tests.Drawing;

/// <summary>Whole charts, element by element, against the table of what was asked.</summary>
public sealed class ChartPageTests
{
    private const string k_Grid = "#ded8c8", k_Axis = "#8a8272";

    // Labels of at most six places: every second of seven.
    [TestCase(6, 1)]
    [TestCase(7, 2)]
    [TestCase(13, 3)]
    public void ALineChart_IsItsTitleGridLabelsAxisAndCurves_AndNothingElse(int count, int labelled)
    {
        double[] places = [.. Enumerable.Range(0, count).Select(k => 2.0 * k)], values = [.. places.Select(place => 10.0 - place)];
        values[1] = double.NaN;
        var page = new SvgPage();
        new LineChart(places, false, 100f, 50f, 456f, 250f).Draw(page, "a < b",
            [new ChartCurve(values, "#123456", false), new ChartCurve([.. values.Select(value => 0.5 * value)], "#654321", true)]);

        // The frame: 44 for labels on the left, 12 on the right, 26 above, 24 below.
        const double left = 144.0, top = 76.0, right = 544.0, bottom = 276.0;
        var up = ChartAxis.Linear(values);
        double Along(int k) => left + (right - left) * k / (count - 1);
        double Down(double value) => bottom - (bottom - top) * (value - up.From) / (up.To - up.From);
        var asked = new List<string> { Text(108, top - 10, 13, "a < b", look: "b") };
        foreach (double tick in up.Ticks)
        {
            asked.Add(Line(left, Down(tick), right, Down(tick), k_Grid));
            asked.Add(Text(left - 6, Down(tick) + 4, 11, $"{tick:0.###}".Replace('-', '−'), "end", "t"));
        }

        for (int k = 0; k < count; k += labelled)
        {
            asked.Add(Line(Along(k), bottom, Along(k), bottom + 4, k_Axis));
            asked.Add(Text(Along(k), bottom + 17, 11, $"{places[k]:0}", "middle", "t"));
        }

        asked.Add(Line(left, bottom, right, bottom, k_Axis));
        foreach ((double scale, string colour, double radius, string dash) in
            new[] { (1.0, "#123456", 2.6, ""), (0.5, "#654321", 1.8, " stroke-dasharray=5 4") })
        {
            int[] shown = [.. Enumerable.Range(0, count).Where(k => k != 1)];
            asked.AddRange(shown.Select(k =>
                FormattableString.Invariant($"circle cx={Along(k)} cy={Down(scale * values[k])} r={radius} fill={colour}")));
            asked.Add("path d=" + string.Concat(shown.Select(k => FormattableString.Invariant(
                $"{(k == 0 ? 'M' : 'L')}{Along(k)} {Down(scale * values[k])}"))) + $" fill=none stroke={colour} stroke-width=2{dash}");
        }

        AssertAre(page, asked);
    }

    [Test]
    public void APointChart_IsItsTitleGridLabelsAndAxis_ThenWhatIsDrawn()
    {
        ChartAxis across = new(0.0, 10.0, false, [0.0, 5.0, 10.0]), up = new(-2.0, 2.0, false, [-2.0, 2.0]);
        var page = new SvgPage();
        var chart = new PointChart(page, "title", across, up, 20f, 30f, new float2(358f, 260f));
        // Within are the first, the corners and no others.
        ChartPoint[] points = [new(4.0, 1.0), new(0.0, -2.0), new(10.0, 2.0), new(-0.1, 0.0), new(10.1, 0.0), new(5.0, -2.1),
            new(5.0, 2.1)];
        var looks = new (CurveLook Look, string Stroke)[]
        {
            (CurveLook.Discs, "stroke-width=2"), (CurveLook.Squares, "stroke-width=2 stroke-dasharray=5 4"),
            (CurveLook.Plain, "stroke-width=2"), (CurveLook.Dashed, "stroke-width=2 stroke-dasharray=5 4"),
            (CurveLook.Thin, "stroke-width=1"), (CurveLook.Dotted, "stroke-width=1.5 stroke-dasharray=1.5 3"),
        };
        foreach ((CurveLook look, _) in looks)
            chart.Draw(new PointCurve(points, "#abcdef", look));
        chart.Ring(points[0], "#111111");
        chart.Cross(points[1], "#222222");
        chart.Remark("remark");

        // The frame: 44 for labels on the left, 14 on the right, 34 above, 26 below.
        const double left = 64.0, top = 64.0, right = 364.0, bottom = 264.0;
        double X(double value) => left + (right - left) * value / 10.0;
        double Y(double value) => bottom - (bottom - top) * (value + 2.0) / 4.0;
        List<string> asked =
        [
            Text(30, 48, 14, "title", look: "b"), "clipPath id=c20-30", $"rect x={left} y={top} width={right - left} height={bottom - top}",
        ];
        foreach (double tick in up.Ticks)
        {
            asked.Add(Line(left, Y(tick), right, Y(tick), k_Grid));
            asked.Add(Text(left - 6, Y(tick) + 4, 11, tick < 0 ? "−2" : "2", "end", "t"));
        }

        foreach (double tick in across.Ticks)
        {
            asked.Add(Line(X(tick), top, X(tick), bottom, k_Grid));
            asked.Add(Text(X(tick), bottom + 16, 11, $"{tick:0}", "middle", "t"));
        }

        asked.Add(Line(left, bottom, right, bottom, k_Axis));
        foreach ((CurveLook look, string stroke) in looks)
        {
            string way = string.Concat(points.Select((point, k) =>
                FormattableString.Invariant($"{(k == 0 ? 'M' : 'L')}{X(point.X)} {Y(point.Y)}")));
            asked.Add($"path clip-path=url(#c20-30) d={way} fill=none stroke=#abcdef {stroke}");
            if (look is CurveLook.Discs or CurveLook.Squares)
                asked.AddRange(points.Take(3).Select(point => Mark(look, X(point.X), Y(point.Y))));
        }

        asked.Add(FormattableString.Invariant($"circle cx={X(4)} cy={Y(1)} r=6.5 fill=none stroke=#111111 stroke-width=1.5"));
        asked.Add(Cross(X(0), Y(-2), "#222222"));
        asked.Add(Text(right, top - 16, 11, "remark", "end", "t"));
        AssertAre(page, asked);
    }

    // Each entry is as wide as its mark and its letters, and a gap of 26 lies behind it.
    [TestCase(1)]
    [TestCase(2)]
    public void ALegend_HasAMarkBeforeEachText_EntriesBesideOneAnother(int kinds)
    {
        var page = new SvgPage();
        var legend = new ChartLegend(page, 100f);
        legend.Add("discs", "#111111", CurveLook.Discs);
        legend.Add("squares", "#222222", CurveLook.Squares);
        legend.AddRing("ring", "#333333");
        legend.AddCross("a cross", "#444444");
        legend.AddText("words");
        legend.NextLine();
        legend.AddWings([(1, 0), (kinds, 0)]);
        legend.AddText("end");

        double x = 26.0, y = 100.0;
        var asked = new List<string>();
        void Say(string text, double mark)
        {
            asked.Add(Text(x + mark, y + 4, 13, text));
            x += mark + 6.4 * text.Length + 26.0;
        }

        foreach ((string text, string colour, CurveLook look, string dash) in new[]
        {
            ("discs", "#111111", CurveLook.Discs, ""), ("squares", "#222222", CurveLook.Squares, " stroke-dasharray=5 4"),
        })
        {
            asked.Add(FormattableString.Invariant($"path d=M{x} {y}h28 stroke={colour} fill=none stroke-width=2{dash}"));
            asked.Add(Mark(look, x + 14, y, colour));
            Say(text, 34);
        }

        asked.Add(FormattableString.Invariant($"circle cx={x + 8} cy={y} r=6.5 fill=none stroke=#333333 stroke-width=1.5"));
        Say("ring", 22);
        asked.Add(Cross(x + 6, y, "#444444"));
        Say("a cross", 20);
        asked.Add(Text(x, y + 4, 13, "words", look: "t"));
        (x, y) = (26.0, y + 24.0);
        foreach (string wing in kinds > 1 ? new[] { "fore wing, or the only one", "hind wing" } : ["wing"])
        {
            asked.Add(FormattableString.Invariant($"circle cx={x + 6} cy={y} r=5 fill={(wing[0] == 'h' ? "#c2410c" : "#0b5fa5")}"));
            Say(wing, 18);
        }

        asked.Add(Text(x, y + 4, 13, "end", look: "t"));
        AssertAre(page, asked);
    }

    [TestCase(1, 1)]
    [TestCase(3, 1)]
    [TestCase(4, 2)]
    [TestCase(7, 3)]
    public void ASheet_HasRowsOfThree_BelowItsHeading_AndIsAsHighAsTheyNeed(int count, int rows)
    {
        var sheet = new ChartSheet("heading", "caption");
        ChartAxis axis = new(0.0, 1.0, false, []);
        for (int k = 0; k < count; k++)
            sheet.Chart(k, $"chart {k}", axis, axis);
        string[] drawn = Of(sheet.Page);

        Assert.That(drawn[..2], Is.EqualTo(new[] { Text(26, 38, 22, "heading", look: "b"), Text(26, 60, 13, "caption", look: "t") }));
        Assert.That(sheet.LegendTop, Is.GreaterThan(60f).And.LessThan(136f - 24f), "two lines below the caption, above the charts");
        double width = 974.0 / 3.0;
        string[] titles = [.. drawn.Skip(2).Where(element => element.StartsWith("text"))];
        string[] frames = [.. drawn.Where(element => element.StartsWith("rect"))];
        for (int k = 0; k < count; k++)
        {
            double left = 12.0 + k % 3 * width, top = 136.0 + 280.0 * (k / 3);
            Assert.That(titles[k], Is.EqualTo(Text(Math.Round(left + 10, 2), top + 18, 14, $"chart {k}", look: "b")));
            Assert.That(frames[k], Is.EqualTo(FormattableString.Invariant(
                $"rect x={left + 44:0.#} y={top + 34} width={width - 58:0.#} height=220")));
        }

        string page = sheet.Finish(count, "all");
        Assert.That(page, Does.Contain($"viewBox=\"0 0 1000 {136 + 280 * rows + 12}\"").And.Contain("<title>all</title>"));
    }

    [Test]
    public void AnAxisOfRatios_IsTheShortestOfItsTicks_ThatHoldsItsValues()
    {
        var random = new System.Random(7);
        for (int k = 0; k < 300; k++)
        {
            double least = Math.Pow(10.0, 6.0 * random.NextDouble() - 3.0),
                most = least * (k % 4 == 0 ? 1.0 : Math.Pow(10.0, 2.0 * random.NextDouble()));
            if (k % 5 == 0)
                least = Tick(random.Next(-9, 9));
            if (k % 7 == 0)
                most = least * Tick(3 * random.Next(3));
            most = Math.Max(least, most);
            var axis = ChartAxis.Logarithmic(least, most);
            double[] ticks = [.. axis.Ticks];

            Assert.That((axis.IsLogarithmic, axis.From, axis.To), Is.EqualTo((true, ticks[0], ticks[^1])));
            Assert.That(ticks.Select(tick => Number(tick) - Number(ticks[0])), Is.EqualTo(Enumerable.Range(0, ticks.Length)),
                "none left out");
            Assert.That(ticks.All(tick => Math.Abs(Tick(Number(tick)) / tick - 1.0) < 1e-9), Is.True, "1, 2 and 5 times powers of ten");
            Assert.That(ticks.Length, Is.GreaterThan(1));
            Assert.That(ticks[0], Is.LessThan(least * (1 + 1e-8)));
            Assert.That(ticks[^1], Is.GreaterThan(most * (1 - 1e-8)));
            Assert.That(ticks[1], Is.GreaterThan(least * (1 + 1e-10)), "nothing below the values");
            Assert.That(ticks.Length == 2 || ticks[^2] < most * (1 - 1e-10), Is.True, "nothing above them");
        }
    }

    [Test]
    public void AnAxis_HasTheFinestRoundSteps_OfWhichFourSpanItsValues_AndNoneTooMuchForRoundOnes()
    {
        var random = new System.Random(11);
        double[] round = [1.0, 2.0, 2.5, 5.0, 10.0];
        for (int k = 0; k < 300; k++)
        {
            double power = Math.Pow(10.0, random.Next(-3, 4)), span = power * (1.0 + 9.0 * random.NextDouble());
            double step = ChartAxis.Linear([span]).Ticks[1];
            double finer = round.Concat(round.Select(factor => 0.1 * factor)).Select(factor => factor * power)
                .Where(other => other < 0.99 * step).Max();
            Assert.That(span / step, Is.LessThan(4.01));
            Assert.That(span / finer, Is.GreaterThan(4.0));

            double unit = power * round[k % 4];
            var whole = ChartAxis.Linear([unit * 3.0, -unit]);
            Assert.That(whole.To, Is.EqualTo(3.0 * unit).Within(1e-6 * unit), "a value on a tick ends the axis");
            Assert.That(whole.From, Is.EqualTo(-unit).Within(1e-6 * unit));
        }

        Assert.That(ChartAxis.Linear([0.97e-6]).To, Is.EqualTo(1.0), "too little to be shown");
        Assert.That(ChartAxis.Linear([1.03e-6]).To, Is.LessThan(1.6e-6));
    }

    [Test]
    public void APage_SaysItsSizeAndTitle_AndHasItsPaperBelow()
    {
        string page = new SvgPage().Finish(300f, 120.5f, "R&D");

        Assert.That(page, Does.StartWith("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 300 120.5\" "));
        Assert.That(page, Does.Contain("width=\"300\" height=\"120.5\">\n<title>R&amp;D</title>"));
        Assert.That(page, Does.Contain("<rect width=\"300\" height=\"120.5\" rx=\"14\" fill=\"#f7f4ec\"/>"));
    }

    private static string Mark(CurveLook look, double x, double y, string colour = "#abcdef") => FormattableString.Invariant(
        look == CurveLook.Discs ? $"circle cx={x} cy={y} r=3 fill={colour}"
        : (FormattableString)$"rect x={x - 2.7} y={y - 2.7} width=5.4 height=5.4 fill=#f7f4ec stroke={colour} stroke-width=1.3");

    private static string Cross(double x, double y, string colour) => FormattableString.Invariant(
        $"path d=M{x - 4} {y - 4}l8 8m0-8l-8 8 fill=none stroke={colour} stroke-width=2");

    // Ticks of ratios, numbered from 1.
    private static double Tick(int number) =>
        new[] { 1.0, 2.0, 5.0 }[((number % 3) + 3) % 3] * Math.Pow(10.0, Math.Floor(number / 3.0));

    private static int Number(double tick)
    {
        double power = Math.Floor(Math.Log10(tick) + 1e-9), mantissa = tick / Math.Pow(10.0, power);
        return 3 * (int)power + (mantissa < 1.5 ? 0 : mantissa < 3.5 ? 1 : 2);
    }
}
