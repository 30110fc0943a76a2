using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;

namespace Alate.Tests.Cli;

/// <summary>path.png of flights whose way is known.</summary>
public sealed class WayPictureLaws
{
    private const double k_Frequency = 10.0, k_Step = 0.02;

    private static double Reach => MonarchFlight.Level.Wings.Max(wing => math.length(wing.Placement.Hinge) + wing.Placement.Length);

    // Ahead and up, from 1 to 3 metres and half of that up, in four seconds: on the map it leads up, in the profile to the right.
    [Test]
    public void TheWay_LeadsUpOnTheMap_AndToTheRightOverItsDistance_InTheColoursOfItsHeight()
    {
        PixelPage page = Page(200, time => new float3(0f, 0.25f * (float)time, 1f + 0.5f * (float)time), out float factor);
        float2[] map = Way(page, 1.2f), profile = Way(page, 0.9f);

        // 2 m fill the map's 430 units but for 56 above and below.
        const double k_Scale = (430.0 - 112.0) / 2.0;
        Assert.That(factor, Is.EqualTo(44.0 / (k_Scale * Reach)).Within(0.1).Percent, "an insect reaches 44 units");
        AssertNear(map[0], 26.0 + 439.0, 76.0 + 215.0 + k_Scale);
        AssertNear(map[^1], 26.0 + 439.0, 76.0 + 215.0 - k_Scale);
        Assert.That(map.Zip(map.Skip(1), (a, b) => b.y - a.y), Is.All.LessThanOrEqualTo(0f), "without a way back");
        AssertNear(profile[0], 76.0, 556.0 + 186.0);
        AssertNear(profile[^1], 676.0, 556.0);
        (float2[] Points, float Pen, float3 Colour)[] lines = [.. page.Strokes.Where(stroke => stroke.Pen == 1.2f)];
        Assert.That(lines.Select(line => line.Colour).Distinct().Count(), Is.GreaterThan(20));
        Assert.That(lines[0].Colour.z, Is.GreaterThan(lines[0].Colour.x), "blue is low");
        Assert.That(lines[^1].Colour.x, Is.GreaterThan(lines[^1].Colour.z), "red is high");
        foreach (float2[] line in page.Strokes.Select(stroke => stroke.Points).Where(line => line.Length == 2))
        {
            (float2 low, float2 high) = (math.min(line[0], line[1]), math.max(line[0], line[1]));
            if (low.x == high.x && high.y - low.y > 100f)
                Assert.That(low.y >= 555f && high.y <= 743f || high.y <= 540f, Is.True, $"a line of the grid leaves it: {low}, {high}");
        }
    }

    [Test]
    public void Times_StandBesideTheirPlaces_StartAndEndAtTheEnds_AndWordsBesideEachOther()
    {
        PixelPage page = Page(200, time => new float3((float)time, 0.1f * (float)time, 0.4f * MathF.Sin((float)time)), out _);
        float2[] map = Way(page, 1.2f);
        PixelWords[] times = [.. page.Words.Where(word => word.Text.EndsWith(" s") && word.At.y < 520f && word.Size == 13f)];

        Assert.That(times.Select(word => word.Text), Is.EqualTo(new[] { "0.5 s", "1 s", "1.5 s", "2 s", "2.5 s", "3 s", "3.5 s" }));
        for (int k = 0; k < times.Length; k++)
            Assert.That(math.distance(Middle(times[k]), map[25 * (k + 1)]), Is.LessThan(65f), times[k].Text);
        Assert.That(math.distance(Middle(page.Words.Single(word => word.Text == "start")), map[0]), Is.LessThan(45f));
        Assert.That(math.distance(Middle(page.Words.Single(word => word.Text == "end")), map[^1]), Is.LessThan(45f));
        PixelWords[] all = [.. page.Words.Where(word => word.At.y is > 70f and < 520f)];
        foreach ((PixelWords one, PixelWords other) in all.SelectMany((one, k) => all.Skip(k + 1).Select(other => (one, other))))
        {
            bool beside = one.At.x + Lettering.Width(one.Text, 13f) < other.At.x
                || other.At.x + Lettering.Width(other.Text, 13f) < one.At.x;
            Assert.That(beside || Math.Abs(one.At.y - other.At.y) > 13f, Is.True, $"{one.Text}, {other.Text}");
        }
    }

    [Test]
    public void ThreeInsects_FlyWhereTheyWere_BetweenTheMarks_AndNoneCoversAnother()
    {
        PixelPage page = Page(200, time => new float3((float)time, 0f, 0f), out float factor);
        float2[] map = Way(page, 1.2f);
        float2[] insects = [.. page.Panels.Select(panel => new float2(panel.Left + 0.5f * panel.Width, panel.Top + 0.5f * panel.Height))];

        Assert.That(insects, Has.Length.EqualTo(3));
        // Marks every half second, 25 moments, make eight parts: the second, fifth and seventh have the insects.
        foreach ((float2 insect, int moment) in insects.Zip(new[] { 37, 112, 162 }))
            AssertNear(insect, map[moment].x, map[moment].y);
        PixelPage there = Page(200, time => new float3((float)Math.Sin(Math.PI * time / 4.0), 0f, 0f), out _);
        Assert.That(there.Panels, Has.Count.InRange(1, 2), "on its way back it is where it was");
        Assert.That(factor, Is.GreaterThan(1.5f));
        Assert.That(page.Title, Does.Contain("4 m flown").Or.Contain("3.98 m flown").And.Contain("times as large as their way"));
    }

    // An insect that hovers is as large as it is, once, and its height goes over time.
    [Test]
    public void AnInsectThatHovers_IsAsLargeAsItIs_AndItsHeightIsOverTime()
    {
        PixelPage page = Page(200, time => 0.004f * new float3(0f, (float)Math.Cos(20.0 * Math.PI * time), 0f), out float factor);

        Assert.That(factor, Is.EqualTo(1f));
        Assert.That(page.Panels, Has.Count.EqualTo(1));
        Assert.That(page.Texts, Has.Some.Contains("over time, s").And.Some.EqualTo("start, end"));
        Assert.That(page.Title, Does.Not.Contain("times as large"));
        Assert.That(page.Texts, Has.Some.StartsWith("Height, cm"));
    }

    // A flight of one step, and of one that is as short as a beat.
    [Test]
    public void AFlightOfFewSteps_IsDrawnToo([Values(0, 1, 2)] int moments)
    {
        PixelPage page = Page(moments, time => new float3(0f, 0f, (float)time), out float factor);

        Assert.That(page.Panels, Has.Count.EqualTo(1));
        Assert.That(factor, Is.EqualTo(1f));
        Assert.That(page.Strokes.SelectMany(stroke => stroke.Points).All(point => math.all(math.isfinite(point))), Is.True);
    }

    // Of two harmonics the loop is what was put in, about a mean that flies on.
    [Test]
    public void TheBobOfABeat_IsWhatTheBodyDoesBesideItsMeanFlight()
    {
        static float2 Bob(double phase) => new(
            (float)(0.002 * Math.Sin(phase)), (float)(0.004 * Math.Cos(phase) - 0.001 * Math.Sin(2.0 * phase)));
        FreeRecord flight = Record(400, time =>
        {
            float2 bob = Bob(2.0 * Math.PI * k_Frequency * time);
            return new float3(0f, 0.1f * (float)time + bob.y, (float)time + bob.x);
        }, 0.0125);
        float2[] loop = BeatBob.Loop(flight, new FlownWay(flight));

        // The mean over nine moments of a beat of eight keeps a ninth of the bob.
        for (int k = 0; k < loop.Length; k++)
            Assert.That(math.distance(loop[k], Bob(2.0 * Math.PI * k / (loop.Length - 1))), Is.LessThan(0.0008f), $"{k}");
        Assert.That(math.distance(loop[0], loop[^1]), Is.LessThan(1e-6f), "it closes");
        float2 span = loop.Aggregate(math.max) - loop.Aggregate(math.min);
        Assert.That(PathPicture.Compose(flight, out _).Texts, Has.Some.EqualTo(FormattableString.Invariant(
            $"{1000.0 * span.y:0.0} mm up and down, {1000.0 * span.x:0.0} along")));
        Assert.That(BeatBob.Loop(Record(6, _ => 0f, k_Step), new FlownWay(Record(6, _ => 0f, k_Step))), Is.Empty, "too short");
    }

    [Test]
    public void ALongFlight_IsDrawnByFewPoints_WithoutItsBob()
    {
        PixelPage page = Page(60000, time => new float3(0.01f * (float)Math.Cos(20.0 * Math.PI * time), 0f, (float)time), out _);
        float2[] map = Way(page, 1.2f);

        Assert.That(map, Has.Length.InRange(1000, 2600));
        Assert.That(page.Texts, Has.Some.EqualTo("600 s"));
    }

    [Test]
    public void ThePicture_IsAsLargeAsItsPage()
    {
        byte[] drawn = PathPicture.Draw(Record(50, time => new float3(0f, 0f, (float)time), k_Step), out _);
        var picture = PngFile.Read(drawn);

        Assert.That((picture.Width, picture.Height), Is.EqualTo((1395, 1200)));
    }

    private static PixelPage Page(int moments, Func<double, float3> at, out float factor) =>
        PathPicture.Compose(Record(moments, at, k_Step), out factor);

    private static FreeRecord Record(int count, Func<double, float3> at, double step) => new(
        InsectCatalogue.Find("monarch"),
        [.. Enumerable.Range(0, count + 1).Select(k => new FreeMoment(
            step * k, at(step * k), quaternion.identity, 0f, 0f, 0f, 0f, 2.0 * Math.PI * (k_Frequency * step * k % 1.0), k_Frequency, 1, 0f,
            0f, 0, 0, FlightState.Flying))],
        0f, 1, MonarchFlight.Level);

    // The lines of the way, one after the other, by their half width.
    private static float2[] Way(PixelPage page, float pen)
    {
        var points = new List<float2>();
        foreach ((float2[] stroke, float half, float3 _) in page.Strokes.Where(stroke => stroke.Pen == pen))
            points.AddRange(points.Count > 0 ? stroke.Skip(1) : stroke);
        return [.. points];
    }

    private static float2 Middle(PixelWords words) => words.At + new float2(0.5f * Lettering.Width(words.Text, words.Size), -5f);

    private static void AssertNear(float2 place, double x, double y) =>
        Assert.That(math.distance(place, new float2((float)x, (float)y)), Is.LessThan(1.5f), $"{place}");
}
