using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Measures of tracks against tracks of known shape, and the part of the page of results that shows them.</summary>
public sealed class WanderPageTests
{
    private const float k_Rate = 20f;

    [Test]
    public void AStraightTrack_IsStraight_AndDoesNotTurn()
    {
        WanderStatistics track = Of(seconds => new float3(0.8f * seconds, 0.3f * math.sin(9f * seconds), -0.6f * seconds));
        Assert.That(track.Straightness, Is.All.EqualTo(1).Within(1e-4), "height does not count");
        Assert.That(track.Turning, Is.LessThan(0.1));
    }

    // A chord of an arc of the angle φ over the arc is 2 sin(φ/2)/φ.
    [TestCase(1.2f)]
    [TestCase(-0.4f)]
    public void ACircle_TurnsAsItDoes_AndIsAsStraightAsItsChords(float rate)
    {
        WanderStatistics track = Of(seconds => new float3(math.cos(rate * seconds), 0f, math.sin(rate * seconds)) / math.abs(rate));
        Assert.That(track.Turning, Is.EqualTo(180 / Math.PI * Math.Abs(rate)).Within(1).Percent);
        for (int lag = 0; lag < 4; lag++)
        {
            double angle = Math.Abs(rate) * WanderStatistics.Lags[lag];
            Assert.That(track.Straightness[lag], Is.EqualTo(2 * Math.Sin(angle / 2) / angle).Within(0.005), $"{lag}");
        }
    }

    // A course that swings by A sin ωt turns by A ω cos ωt; its variance, A²ω²/2, is the area below the spectrum, around that frequency.
    [Test]
    public void TheSpectrumOfACourseThatSwings_HasItsVarianceAtItsFrequency()
    {
        const double k_Hertz = 0.5, k_Swing = 0.4, k_Omega = 2 * Math.PI * k_Hertz;
        var place = new float3[2];
        WanderStatistics track = Of(seconds =>
        {
            double heading = k_Swing * Math.Sin(k_Omega * seconds);
            float3 now = place[0];
            place[0] += new float3((float)Math.Sin(heading), 0f, (float)Math.Cos(heading)) / k_Rate;
            return now;
        });
        double variance = Math.Pow(180 / Math.PI * k_Swing * k_Omega, 2) / 2,
            width = WanderStatistics.Frequencies[1] - WanderStatistics.Frequencies[0];
        int peak = track.Spectrum.ToList().IndexOf(track.Spectrum.Max());
        Assert.That(WanderStatistics.Frequencies[peak], Is.EqualTo(k_Hertz).Within(1e-6));
        Assert.That(track.Spectrum.Sum() * width, Is.EqualTo(variance).Within(8).Percent,
            "the course over two tenths of a second swings a little less");
        Assert.That(track.Turning, Is.EqualTo(Math.Sqrt(variance)).Within(5).Percent);
    }

    [Test]
    public void AChart_HasACurveEachForStraightnessAndTurning()
    {
        WanderStatistics one = Of(seconds => new float3(math.cos(seconds), 0f, math.sin(seconds)));
        using var folder = new TemporaryFolder();
        string file = folder.PathOf("wander.svg");
        File.WriteAllText(file, WanderFigures.Draw([one, one with { Erratic = 1 }]));
        SvgBounds.AssertAllIsOnThePage(file);
        string[][] rows = [.. WanderFigures.Table([one])];
        Assert.That(rows[1][0], Is.EqualTo("Circle"));
        Assert.That(rows[1][4..7], Is.EqualTo(new[] { "0.96", "0.45", "57" }), "2 sin(1/2), sin(2)/2, and a radian a second");
    }

    // The more erratic, the more an insect turns; a monarch pays for it with a fifth of its power. ALATE_WRITE_FIGURES=1 writes chart and
    // table again, as figures does with all pages.
    [Test]
    [Explicit]
    [Category("Long")]
    public void ThePagesNumbers_AreThoseOfToday()
    {
        string folder = Path.Combine(PackageRoot.Find(), "Documentation~"), file = Path.Combine(folder, FlightFigures.Page);
        string page = File.ReadAllText(file).ReplaceLineEndings("\n");
        List<WanderStatistics> measured = WanderFigures.Measure();
        foreach (IGrouping<string, WanderStatistics> one in measured.GroupBy(one => one.Species))
        {
            Assert.That(one.Sum(at => at.Tumbled), Is.Zero, one.Key);
            Assert.That(one.Select(at => at.Turning), Is.Ordered, one.Key);
            Assert.That(one.Last().PowerOverSteady, Is.GreaterThan(one.First().PowerOverSteady - 0.02), one.Key);
        }

        Assert.That(measured.Single(one => one.Species == "Monarch" && one.Erratic == 1).PowerOverSteady, Is.InRange(1.2, 1.5));
        (string made, string chart) = WanderFigures.Make(page, measured);
        if (Environment.GetEnvironmentVariable("ALATE_WRITE_FIGURES") == "1")
        {
            File.WriteAllText(file, made);
            File.WriteAllText(Path.Combine(folder, WanderFigures.Picture), chart);
        }

        Assert.That(made, Is.EqualTo(File.ReadAllText(file).ReplaceLineEndings("\n")), "run figures");
    }

    private static WanderStatistics Of(Func<float, float3> place)
    {
        var track = new WanderStatistics("Circle", 0);
        track.Add([.. Enumerable.Range(0, 800).Select(k => place(k / k_Rate))]);
        return track;
    }
}
