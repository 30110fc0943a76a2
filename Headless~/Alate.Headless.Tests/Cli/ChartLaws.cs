using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Laws of axes, charts and cameras: what is drawn lies where its numbers say.</summary>
public sealed class ChartLaws
{
    private static readonly XNamespace s_Svg = "http://www.w3.org/2000/svg";

    [Test]
    public void AnAxisAroundValues_IsNoLongerThanTheyAsk_FarFromNought()
    {
        var random = new System.Random(6);
        for (int k = 0; k < 200; k++)
        {
            double middle = 1e4 * (random.NextDouble() - 0.5), size = Math.Pow(10.0, 4.0 * random.NextDouble() - 2.0);
            double[] values = [.. Enumerable.Range(0, 5).Select(_ => middle + size * random.NextDouble())];
            var axis = ChartAxis.Around(values);
            double step = axis.Ticks[1] - axis.Ticks[0];
            Assert.That(axis.From, Is.InRange(values.Min() - 1.001 * step, values.Min() + 1e-6));
            Assert.That(axis.To, Is.InRange(values.Max() - 1e-6, values.Max() + 1.001 * step));
            Assert.That(axis.Ticks, Has.Count.InRange(3, 7));
        }

        ChartAxis flat = ChartAxis.Around([5000.0, 5000.0, double.NaN]), none = ChartAxis.Around([double.NaN]);
        Assert.That((flat.From, flat.To), Is.EqualTo((5000.0, 5005.0)).Using<(double, double)>(
            (one, other) => Math.Abs(one.Item1 - other.Item1) < 1.0 && Math.Abs(one.Item2 - other.Item2) < 2.0 ? 0 : 1));
        Assert.That((none.From, none.To), Is.EqualTo((0.0, 1.0)));
    }

    [Test]
    public void AnAxis_HoldsItsValuesAndNought_WithFewRoundTicks()
    {
        var random = new System.Random(5);
        for (int k = 0; k < 300; k++)
        {
            double size = Math.Pow(10.0, 6.0 * random.NextDouble() - 3.0);
            double[] values = Enumerable.Range(0, 5).Select(_ => size * (random.NextDouble() - (k % 3 == 0 ? 0.0 : 0.4)))
                .Append(double.NaN).ToArray();
            var axis = ChartAxis.Linear(values);
            double step = axis.Ticks[1] - axis.Ticks[0], mantissa = step / Math.Pow(10.0, Math.Floor(Math.Log10(step) + 1e-9));

            Assert.That((axis.From, axis.To), Is.EqualTo((axis.Ticks[0], axis.Ticks[^1])));
            Assert.That(axis.From, Is.LessThanOrEqualTo(Math.Min(0.0, values[..5].Min()) + 1e-9 * size));
            Assert.That(axis.To, Is.GreaterThanOrEqualTo(Math.Max(0.0, values[..5].Max()) - 1e-9 * size));
            Assert.That(axis.From, Is.GreaterThan(Math.Min(0.0, values[..5].Min()) - step * 1.001), "no empty step at its ends");
            Assert.That(axis.To, Is.LessThan(Math.Max(0.0, values[..5].Max()) + step * 1.001));
            Assert.That(axis.Ticks, Has.Count.InRange(3, 7));
            Assert.That(new[] { 1.0, 2.0, 2.5, 5.0 }.Min(round => Math.Abs(mantissa - round)), Is.LessThan(1e-6), $"steps of {step}");
            Assert.That(axis.Ticks.Min(Math.Abs), Is.LessThan(1e-9 * step), "nought has a tick");
        }

        Assert.That(ChartAxis.Linear([0.0, 0.0]).Ticks[^1], Is.EqualTo(1.0), "nothing but nought");
    }

    [Test]
    public void AShare_IsThatOfTheWay_OrOfTheRatio()
    {
        Assert.That(new ChartAxis(2.0, 10.0, false, []).Fraction(4.0), Is.EqualTo(0.25f));
        Assert.That(new ChartAxis(1.0, 100.0, true, []).Fraction(10.0), Is.EqualTo(0.5f).Within(1e-6f));
        Assert.That(ChartAxis.Logarithmic(0.03, 2.1).Ticks, Is.EqualTo(new[] { 0.02, 0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0 }).Within(1e-9));
    }

    [TestCase(false)]
    [TestCase(true)]
    public void ALineChart_HasItsPointsBetweenTheTicks_AsTheirNumbersLie(bool isLogarithmic)
    {
        double[] places = [1.0, 2.0, 4.0, 8.0], values = [3.0, -1.0, double.NaN, 7.5];
        var page = new SvgPage();
        new LineChart(places, isLogarithmic, 100f, 50f, 400f, 200f).Draw(page, "title", [new ChartCurve(values, "#123456", false)]);
        var svg = XElement.Parse(page.Finish(600f, 300f, "a chart"));
        Dictionary<double, double> heights = Labels(svg, "end", "y"), ways = Labels(svg, "middle", "x");
        (double X, double Y)[] points = svg.Elements(s_Svg + "circle")
            .Select(circle => (Number(circle, "cx"), Number(circle, "cy"))).ToArray();

        Assert.That(points, Has.Length.EqualTo(3), "what is no number is left out");
        double perUnit = (heights[heights.Keys.Max()] - heights[heights.Keys.Min()]) / (heights.Keys.Max() - heights.Keys.Min());
        Assert.That(perUnit, Is.LessThan(0.0), "more lies higher");
        foreach ((int k, (double x, double y)) in new[] { (0, points[0]), (1, points[1]), (3, points[2]) })
        {
            // Base lines of labels lie four units below their ticks.
            Assert.That(y, Is.EqualTo(heights[0.0] - 4.0 + perUnit * values[k]).Within(0.1));
            Assert.That(x, Is.EqualTo(ways[places[k]]).Within(0.1));
        }

        double half = (ways[2.0] - ways[1.0]) / (ways[8.0] - ways[1.0]);
        Assert.That(half, Is.EqualTo(isLogarithmic ? 1.0 / 3.0 : 1.0 / 7.0).Within(1e-3));
        Assert.That(points.All(point => point.X is >= 144 and <= 488 && point.Y is >= 76 and <= 226), Is.True, "within the frame");
        Assert.That(((string)svg.Element(s_Svg + "title"), (string)svg.Attribute("viewBox")), Is.EqualTo(("a chart", "0 0 600 300")));
    }

    [Test]
    public void APointChart_HasItsPointsBetweenItsTicks_AndMarksOnlyThoseWithin()
    {
        var page = new SvgPage();
        ChartAxis across = new(0.1, 10.0, true, [0.1, 1.0, 10.0]), up = new(-2.0, 2.0, false, [-2.0, 0.0, 2.0]);
        var chart = new PointChart(page, "title", across, up, 20f, 30f, new float2(400f, 300f));
        chart.Draw(
            new PointCurve([new ChartPoint(1.0, 1.0), new ChartPoint(10.0, -1.0), new ChartPoint(5.0, 3.0)], "#123456", CurveLook.Discs));
        chart.Ring(new ChartPoint(0.1, -2.0), "#654321");
        var svg = XElement.Parse(page.Finish(600f, 400f, "points"));
        Dictionary<double, double> heights = Labels(svg, "end", "y"), ways = Labels(svg, "middle", "x");
        (double X, double Y)[] marks = svg.Elements(s_Svg + "circle")
            .Select(circle => (Number(circle, "cx"), Number(circle, "cy"))).ToArray();

        Assert.That(marks, Has.Length.EqualTo(3), "two marks within and the ring");
        Assert.That(marks[0].X, Is.EqualTo(ways[1.0]).Within(0.1));
        Assert.That(marks[0].Y, Is.EqualTo(0.5 * (heights[0.0] + heights[2.0]) - 4.0).Within(0.1));
        Assert.That(marks[1].X, Is.EqualTo(ways[10.0]).Within(0.1));
        Assert.That(marks[1].Y, Is.EqualTo(0.5 * (heights[0.0] + heights[-2.0]) - 4.0).Within(0.1));
        Assert.That(marks[2], Is.EqualTo((ways[0.1], heights[-2.0] - 4.0)).Using<(double, double)>(
            (a, b) => Math.Abs(a.Item1 - b.Item1) + Math.Abs(a.Item2 - b.Item2) < 0.2));
        Assert.That(ways[1.0], Is.EqualTo(0.5 * (ways[0.1] + ways[10.0])).Within(0.1), "equal ratios are equal ways");
    }

    [TestCase("front", 0.3f, 0.1f, 0.2f, -1, 1)]
    [TestCase("back", 0.3f, 0.1f, 0.2f, 1, 1)]
    [TestCase("side", 0.1f, 0.2f, 0.3f, -1, 1)]
    [TestCase("top", 0.3f, 0f, 0.2f, 1, 1)]
    public void ACamera_SeesRightLeftUpAndAhead_FromItsSide(string side, float x, float y, float z, int right, int up)
    {
        var camera = new PictureCamera(PictureView.ByName[side], 50f);
        float3 seen = camera.Project(new float3(x, y, z)), middle = camera.Project(0f);

        Assert.That((math.sign(seen.x), math.sign(-seen.y)), Is.EqualTo(((float)right, (float)up)), "pictures have y down");
        Assert.That(math.distance(middle, new float3(0f, 0f, 50f)), Is.LessThan(1e-4f));
        float3 towards = camera.Towards, across = camera.Direction(1f, 0f, 0f), above = camera.Direction(0f, 1f, 0f);
        Assert.That(math.length(towards), Is.EqualTo(1f).Within(1e-5f));
        Assert.That(math.abs(math.dot(towards, across)) + math.abs(math.dot(towards, above)) + math.abs(math.dot(across, above)),
            Is.LessThan(1e-5f));
        Assert.That(math.distance(camera.Direction(0f, 0f, 1f), towards), Is.LessThan(1e-5f));
        float3 near = camera.Project(0.4f * across + 0.2f * above + 25f * towards);
        Assert.That(math.distance(near, new float3(0.8f, -0.4f, 25f)), Is.LessThan(1e-4f), "at half the distance twice as large");
    }

    [TestCase(10.5, 10.0, 5.0)]
    [TestCase(-9.0, -10.0, 10.0)]
    public void AConvergedValue_DiffersInPerCentOfItsLimit(double now, double limit, double percent) =>
        Assert.That(new ConvergedValue("key", "title", now, limit).DifferencePct, Is.EqualTo(percent).Within(1e-9));

    [Test]
    public void PagesAndTables_KeepWhatStandsAround_AndAskForTheirMarks()
    {
        string begin = "<!-- part: written by the command figures -->\n", page = $"before\n{begin}old\n<!-- end of part -->\nafter\n";

        Assert.That(PageBlock.Replace(page, "part", "new\n"), Is.EqualTo($"before\n{begin}new\n<!-- end of part -->\nafter\n"));
        Assert.That(() => PageBlock.Replace(page, "other", "new"), Throws.Exception.With.Message.Contains("<!-- end of other -->"));
        Assert.That(MarkdownTable.Write([["a", "b|c"], ["1", "2"], ["3", "4"]]),
            Is.EqualTo("| a | b\\|c |\n| --- | --- |\n| 1 | 2 |\n| 3 | 4 |\n"));
    }

    private static Dictionary<double, double> Labels(XElement svg, string anchor, string place) => svg.Elements(s_Svg + "text")
        .Where(text => (string)text.Attribute("text-anchor") == anchor && Regex.IsMatch(text.Value, @"^[−\d.]+$"))
        .ToDictionary(text => double.Parse(text.Value.Replace('−', '-'), CultureInfo.InvariantCulture), text => Number(text, place));

    private static double Number(XElement element, string name) =>
        double.Parse((string)element.Attribute(name), CultureInfo.InvariantCulture);
}
