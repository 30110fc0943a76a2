using System.Collections.Generic;
using System.Linq;
using Alate.Editor;
using NUnit.Framework;
using StandIns;
using UnityEngine;

namespace Alate.Tests.Editor;

/// <summary>Graphs of beats as they are drawn: ground, axes, curve, the newest sample and the numbers beside them.</summary>
public sealed class BeatGraphDrawingTests
{
    private const float k_Padding = 4f;

    [TearDown]
    public void Stop() => (DrawnLines.Calls, DrawnLines.Widths) = (null, null);

    // Sixteen samples a beat from -20 up to 40; the newest, of the second beat, lies at zero and at phase 5/16.
    [TestCase(0.0)]
    [TestCase(0.25)]
    public void AGraph_HasAnAxisAtZero_AndOneAtHalfABeat_AndItsCurveFillsTheHeight(double lag)
    {
        BeatTrace trace = Trace(22);
        (DrawnInspector page, List<(Color Colour, Vector3[] Points)> lines, List<float> widths) = Drawn(Graph(0.1f), trace, lag);
        Rect ground = page.Controls.First(control => control.Kind == ControlKind.Area).Place;
        var inner = Rect.MinMaxRect(
            ground.xMin + k_Padding, ground.yMin + k_Padding, ground.xMax - k_Padding, ground.yMax - k_Padding);
        float zero = inner.yMax - inner.height / 3f;

        Assert.That(ground.height, Is.EqualTo(64f));
        Assert.That(widths, Is.EqualTo(new[] { 1f, 1f, 2f }), "a curve is wider than axes");
        Near(lines[0].Points, new Vector3(inner.xMin, zero, 0f), new Vector3(inner.xMax, zero, 0f));
        Near(lines[1].Points, new Vector3(inner.center.x, inner.yMax, 0f), new Vector3(inner.center.x, inner.yMin, 0f));
        Assert.That(lines[1].Colour, Is.EqualTo(lines[0].Colour));
        Assert.That(lines[0].Colour.a, Is.LessThan(1f), "axes are fainter than curves");
        Assert.That((lines[0].Colour.r, lines[0].Colour.g), Is.EqualTo((lines[0].Colour.b, lines[0].Colour.b)), "grey");
        Assert.That(lines[2].Colour, Is.EqualTo(Color.red));
        Vector3[] curve = lines[2].Points;
        Assert.That((curve.Min(at => at.x), curve.Max(at => at.x)), Is.EqualTo((inner.xMin, inner.xMax)));
        Assert.That((curve.Min(at => at.y), curve.Max(at => at.y)), Is.EqualTo((inner.yMin, inner.yMax)));
        float phase = lag > 0.0 ? 0.75f : 0f;
        Vector3 lowest = curve.First(at => at.y == inner.yMax);
        Assert.That(lowest.x, Is.EqualTo(inner.xMin + phase * inner.width).Within(1e-3f), "what was sampled lay back");

        DrawnControl[] areas = [.. page.Controls.Where(control => control.Kind == ControlKind.Area)];
        DrawnControl mark = areas.Single(area => area.Value == Color.red.ToString());
        Assert.That((mark.Place.center - new Vector2(inner.xMin + (5f / 16f - (float)lag) * inner.width, zero)).magnitude,
            Is.LessThan(0.8f), "the newest, to the pixel");
        Assert.That((mark.Place.width, mark.Place.height), Is.EqualTo((5f, 5f)));
        Assert.That(areas.Single(area => area.Text == "40.0").Place, Is.EqualTo(ground), "the top of the scale");
        Assert.That(areas.Single(area => area.Text == "-20.0").Place,
            Is.EqualTo(new Rect(ground.x, ground.yMax - 18f, ground.width, 18f)), "its bottom, on the last line");
        Assert.That(page.Controls.First(), Has.Property(nameof(DrawnControl.Text)).EqualTo("Flap"));
    }

    [Test]
    public void WithoutSamples_TheScaleIsTheLeast_AndNeitherCurveNorMarkIsDrawn()
    {
        (DrawnInspector page, List<(Color Colour, Vector3[] Points)> lines, _) = Drawn(Graph(10f), new BeatTrace(8, 4.0), 0.0);
        DrawnControl[] areas = [.. page.Controls.Where(control => control.Kind == ControlKind.Area)];

        Assert.That(lines, Has.Count.EqualTo(2), "axes");
        Assert.That(areas.Select(area => area.Text), Is.EqualTo(new[] { "", "5.0", "-5.0" }));
        Assert.That(lines[0].Points[0].y, Is.EqualTo(areas[0].Place.center.y), "zero in the middle");
    }

    [Test]
    public void AValueAboveZeroAlone_StartsAtTheBottom_AndOneBelowItAtTheTop([Values(1f, -1f)] float sign)
    {
        var trace = new BeatTrace(64, 4.0);
        for (int k = 0; k < 16; k++)
            trace.Add(new BeatSample(k / 16.0, sign * (10f + k), 0f));
        (DrawnInspector page, _, _) = Drawn(Graph(0.1f), trace, 0.0);
        string[] told = [.. page.Controls.Where(control => control.Kind == ControlKind.Area && control.Text != "").Select(c => c.Text)];
        Assert.That(told, Is.EqualTo(sign > 0f ? new[] { "25.0", "0.0" } : ["0.0", "-25.0"]));
    }

    private static BeatGraph Graph(float least) =>
        new(new GUIContent("Flap", "of a wing"), "0.0", sample => sample.flap, Color.red, least, 64);

    private static BeatTrace Trace(int samples)
    {
        var trace = new BeatTrace(64, 4.0);
        for (int k = 0; k < samples; k++)
            trace.Add(new BeatSample(k / 16.0, -20f + 4f * (k % 16), 0f));
        return trace;
    }

    private static (DrawnInspector page, List<(Color Colour, Vector3[] Points)> lines, List<float> widths) Drawn(
        BeatGraph graph, BeatTrace trace, double lag)
    {
        DrawnInspector.Of(() => graph.Draw(trace, lag));
        (DrawnLines.Calls, DrawnLines.Widths) = ([], []);
        var page = DrawnInspector.Of(() => graph.Draw(trace, lag));
        return (page, DrawnLines.Calls, DrawnLines.Widths);
    }

    private static void Near(Vector3[] places, params Vector3[] expected)
    {
        Assert.That(places, Has.Length.EqualTo(expected.Length));
        for (int k = 0; k < expected.Length; k++)
            Assert.That((places[k] - expected[k]).magnitude, Is.LessThan(1e-3f), $"{k}: {places[k]}");
    }
}
