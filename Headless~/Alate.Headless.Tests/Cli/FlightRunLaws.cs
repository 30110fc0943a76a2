using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using Unity.StandIns;
using UnityEngine;

namespace Alate.Tests.Cli;

/// <summary>Laws of a flight: what a wing meets, how long a flight takes, what stretches, and what the pictures of a flight say.</summary>
public sealed class FlightRunLaws
{
    // By Pythagoras: 1.5² + 0.75².
    private const double k_Speed = 1.6770509831248424;

    private FlightRecord m_Flown, m_Level;

    [OneTimeSetUp]
    public void Fly()
    {
        m_Flown = OddFlight.Fly();
        m_Level = TetheredFlight.Fly(new FlightPlan { Species = "monarch" });
    }

    [Test]
    public void WhatAWingMeets_IsTheWindLessItsWay_TurnedByThePitch_MirroredOnTheLeft()
    {
        WingPreset preset = InsectCatalogue.Find("fishfly").Wings[0].CreatePreset();
        double p = 20 * Math.PI / 180, length = preset.Size.wingLength;
        double y = 0.25 - 0.75, z = -1 - 1.5;
        foreach (WingSide side in new[] { WingSide.Right, WingSide.Left })
        {
            WingSurroundings met = OddFlight.Plan.SurroundingsOf(preset, side);
            double x = side == WingSide.Right ? 0.5 : -0.5;
            // A nose that is up by the pitch sees what comes level from ahead below it.
            float3 wind = new float3((float)x, (float)(Math.Cos(p) * y - Math.Sin(p) * z),
                (float)(Math.Sin(p) * y + Math.Cos(p) * z)) / (float)length;
            float3 down = new float3(0f, (float)(-9.81 * Math.Cos(p)), (float)(-9.81 * Math.Sin(p)))
                * (float)(preset.Size.gravityShare / length);
            Assert.That(math.distance(met.wind, wind), Is.LessThan(1e-3f * math.length(wind)));
            Assert.That(math.distance(met.gravity, down), Is.LessThan(1e-3f * math.length(down)));
            Assert.That(met.speed, Is.EqualTo(k_Speed).Within(1e-5));
            Assert.That(met.angleOfAttack, Is.EqualTo(p).Within(1e-6));
        }

        float3 up = OddFlight.Plan.UpOfBody, back = OddFlight.Plan.ToWorld(up);
        Assert.That(math.distance(up, new float3(0f, (float)Math.Cos(p), (float)Math.Sin(p))), Is.LessThan(1e-5f));
        Assert.That(math.distance(back, new float3(0f, 1f, 0f)), Is.LessThan(1e-5f), "the way there and back");
        UnityEngine.Object.DestroyImmediate(preset);
    }

    [TestCase(1.0)]
    [TestCase(3.0)]
    [TestCase(11.0)]
    public void AFlight_TakesAsLongAsItIsTold_AndSettlesBefore(double beats)
    {
        FlightPlan plan = new() { Species = "monarch", Substeps = 12, Patches = 64 };
        double frequency = m_Level.Wings[0].Frequency;
        using var flight = new TetheredFlight(plan with { Seconds = beats / frequency }, Insect.Of(plan));
        var told = new List<int>();
        FlightRecord record = flight.Run(told.Add);

        Assert.That(flight.Steps, Is.EqualTo(12 * (int)Math.Max(beats, 8)));
        Assert.That((record.Beats, record.Wings[0].Frames.Count), Is.EqualTo((beats, 12)));
        Assert.That(record.Seconds, Is.EqualTo(beats / frequency).Within(1e-6));
        Assert.That(record.Wings[0].Frames[^1].Time, Is.EqualTo(beats / frequency).Within(1e-6), "the last beat");
        Assert.That(record.Wings[0].Frames[0].Time, Is.EqualTo((beats - 11.0 / 12.0) / frequency).Within(1e-6));
        Assert.That(told, Is.Ordered.Ascending.And.Unique);
        Assert.That(told[^1], Is.EqualTo(flight.Steps));
        int before = flight.Steps - 12;
        Assert.That(told, Is.EqualTo(Enumerable.Range(1, before / 3).Select(k => 3 * k).Concat(Enumerable.Range(before + 1, 12))),
            "four steps a beat, as in a game, and the last beat substep by substep");
        Assert.That(record.MicrosecondsPerSubstep, Is.InRange(0.1, 1e5));
    }

    // The middle one of what is before the last beat, whose steps are recorded; of the last beat where there is nothing else.
    [TestCase(new[] { 5.0, 1, 9, 100, 200 }, 2, 5)]
    [TestCase(new[] { 9.0, 1, 4, 2, 100, 200 }, 2, 4)]
    [TestCase(new[] { 7.0, 300, 200, 100 }, 3, 7)]
    [TestCase(new[] { 3.0, 300, 2 }, 3, 3)]
    [TestCase(new[] { 3.0, 300, 2 }, 8, 3)]
    public void TheCostOfASubstep_IsTheMiddleOne(double[] costs, int last, double middle) =>
        Assert.That(TetheredFlight.Median([.. costs], last), Is.EqualTo(middle));

    [Test]
    public void AFlightThatDrawsAirAlong_SettlesSixBeatsLonger()
    {
        FlightPlan plan = new() { Species = "monarch", Substeps = 12, Patches = 64, Induced = new InducedFlow(1) };
        using var flight = new TetheredFlight(plan, Insect.Of(plan));

        Assert.That(flight.Steps, Is.EqualTo(12 * (8 + 6)));
    }

    [Test]
    public void TheField_IsTheLargestStretchOfTheEdgesAtAVertex_OverTheBeat()
    {
        RecordedWing wing = m_Level.Wings[0];
        float[] largest = new float[wing.Rest.Length];
        var field = new StretchField(wing);
        foreach (RecordedFrame frame in wing.Frames)
        {
            float[] own = new float[wing.Rest.Length];
            for (int k = 0; k < wing.Triangles.Length; k++)
            {
                int a = wing.Triangles[k], b = wing.Triangles[k % 3 == 2 ? k - 2 : k + 1];
                float stretch = math.abs(math.distance(frame.Positions[a], frame.Positions[b]) / math.distance(wing.Rest[a],
                    wing.Rest[b]) - 1f);
                (own[a], own[b]) = (math.max(own[a], stretch), math.max(own[b], stretch));
            }

            float[] told = field.Of(frame.Positions);
            Assert.That(Enumerable.Range(0, own.Length).Max(k => math.abs(own[k] - told[k])), Is.LessThan(1e-5f));
            for (int k = 0; k < own.Length; k++)
                largest[k] = math.max(largest[k], own[k]);
        }

        float[] most = StretchField.Largest(wing);
        Assert.That(Enumerable.Range(0, most.Length).Max(k => math.abs(most[k] - largest[k])), Is.LessThan(1e-5f));
    }

    [Test]
    [Explicit]
    [Category("Long")]
    [Category("Faults")]
    public void TheStretchMap_NamesTheWorstPlace_AndHasItsScaleOfColours()
    {
        RecordedWing wing = m_Level.Wings[0];
        using var folder = new TemporaryFolder();
        string path = folder.PathOf("stretch.png");
        byte[] drawn = StretchMap.Draw(m_Level);
        File.WriteAllBytes(path, drawn);
        string[] texts = PngTexts.Of(path);
        float[] largest = StretchField.Largest(wing);
        int worst = Array.IndexOf(largest, largest.Max());
        double low = wing.Rest.Min(place => place.x), span = (wing.Rest[worst].x - low) / (wing.Rest.Max(place => place.x) - low);
        string told = FormattableString.Invariant($"{100 * largest[worst]:0.0} % on the wing at {100 * span:0} % of its span");

        Assert.That(texts, Is.EqualTo(new[]
        {
            $"Monarch: {told}", "Monarch", "largest stretch of the membrane over a beat", told, "0 %", "8 % and more",
        }));
        var picture = PngFile.Read(drawn);
        Assert.That(picture.Width, Is.EqualTo(1140));
        // The ramp: 220 of 760 units, 26 from the right edge, at 50 from above; five colours and the straight ways between.
        int[] stops = [0xc4d6e4, 0xf2c14e, 0xe4572e, 0x7b1e3a, 0x230a2b];
        for (int k = 2; k < 328; k += 9)
        {
            double at = 4.0 * (k + 0.5) / 330.0;
            int stop = Math.Min((int)at, 3);
            Color32 shown = picture.Pixels[(int)(1.5 * 55) * picture.Width + (int)(1.5 * (760 - 26 - 220)) + k];
            foreach ((int shift, int channel) in new[] { (16, (int)shown.r), (8, shown.g), (0, shown.b) })
            {
                double from = stops[stop] >> shift & 255, to = stops[stop + 1] >> shift & 255;
                Assert.That(channel, Is.EqualTo(from + (at - stop) * (to - from)).Within(12), $"{k}");
            }
        }

        // The wings from above fill the width but for the inset, and lie as much to the left as to the right.
        int[] columns = [.. Enumerable.Range(0, picture.Pixels.Length)
            .Where(k => k / picture.Width > 120 && picture.Pixels[k].b < 200).Select(k => k % picture.Width)];
        Assert.That(columns.Min(), Is.EqualTo(1.5 * 13).Within(4));
        Assert.That(columns.Max(), Is.EqualTo(1140 - 1.5 * 13).Within(4));
    }

    [Test]
    public void TheStrip_SaysTheBeatsLengthItsFrequencyAndTheSpeed()
    {
        FlightRecord flight = m_Flown;
        PixelPage page = BeatStrip.Compose(flight, out StripLayout layout);
        double frequency = flight.Wings[0].Frequency;

        Assert.That(page.Texts.Take(2), Is.EqualTo(new[]
        {
            "Fishfly",
            FormattableString.Invariant($"one beat, {1000 / frequency:0.#} ms at {frequency:0.#} Hz, flying {k_Speed:0.##} m/s"),
        }));
        Assert.That(page.Texts, Has.Count.EqualTo(2 + 2 * 12));
        for (int k = 0; k < 12; k++)
        {
            Assert.That(page.Texts[2 + 2 * k], Is.EqualTo($"{30 * k}°"));
            Assert.That(page.Texts[3 + 2 * k], Is.EqualTo(FormattableString.Invariant($"{1000 * k / 12.0 / frequency:0.0} ms")));
            Assert.That(layout[k].Left, Is.EqualTo(300f * (k % 4)));
        }
    }

    // [chain · (m − 1) + bone], and joints by [chain · m + joint].
    [Test]
    public void JointsAndBendsOfAFrame_LieChainByChain()
    {
        FlightPlan plan = new() { Species = "dragonfly", Substeps = 12, Patches = 64, Speed = 1.3 };
        using var wings = new TetheredWings(plan, Insect.Of(plan));
        wings.World.Step(0.01f);
        wings.World.Skin();
        for (int wing = 0; wing < 4; wing++)
        {
            RecordedFrame frame = wings.FrameOf(wing, 0.25);
            WingReading reading = wings.Read(wing);
            int joints = reading.JointsPerChain, k = 0;
            Assert.That((frame.Joints.Length, frame.Bends.Length, frame.Time),
                Is.EqualTo((reading.ChainCount * joints, reading.ChainCount * (joints - 1), 0.25)));
            for (int chain = 0; chain < reading.ChainCount; chain++)
            {
                for (int bone = 0; bone < joints - 1; bone++, k++)
                    Assert.That(math.distance(frame.Bends[k], reading.BendAngles(chain, bone)), Is.Zero);
                for (int joint = 0; joint < joints; joint++)
                    Assert.That(math.distance(frame.Joints[chain * joints + joint], reading.JointPosition(chain, joint)), Is.Zero);
            }

            Assert.That(frame.Bends.Select(bend => bend.x).Distinct().Count(), Is.GreaterThan(frame.Bends.Length / 2), "all differ");
        }
    }

    [TestCase(9, 20, 1.125)]
    [TestCase(4, 30, 1.2)]
    [TestCase(8, 25, 1.0)]
    public void AWingsStrain_IsTheWorseOfWhatItBears(double p99, double most, double strain)
    {
        var wing = new WingSummary("wing", 10, 20, -3, 4, 10, 8, 20, 10, most, p99);

        Assert.That(FlightSummary.Strain(wing), Is.EqualTo(strain).Within(1e-9));
        Assert.That(MeasureBound.Find("camber_pct").Of(wing), Is.EqualTo(4));
        Assert.That(MeasureBound.Find("camber_pct").Of(wing with { CamberMinPct = -5 }), Is.EqualTo(5), "of either sign");
    }
}
