using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Numbers of free flights beside closed forms: means of made-up moments, a pilot, films and pictures of a way.</summary>
public sealed class FreeFlightLaws
{
    private static readonly FlightLimits s_Limits = new(2f, -0.5f, 0.4f, 2.5f);

    // Two beats of 40 moments: a way at 1.5 m/s that climbs by 0.25 m/s, and on it bobs of height and pitch.
    [Test]
    public void MeansOfAFlight_AreThoseOfItsMoments()
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        const int k_Count = 81;
        var moments = new List<FreeMoment>();
        for (int k = 0; k < k_Count; k++)
        {
            double phase = 2 * Math.PI * (k % 40) / 40.0, time = 3.0 + 0.005 * k;
            bool isDown = phase < Math.PI;
            var pitch = quaternion.AxisAngle(new float3(-1f, 0f, 0f), (float)(0.3 + 0.1 * Math.Cos(phase)));
            moments.Add(new FreeMoment(time, new float3(0.1f, (float)(0.25 * time + 0.002 * Math.Sin(phase)), (float)(1.5 * time)), pitch,
                0f, 0f, 0f, 0f,
                phase, 10.0 + (k % 2), 0.8, isDown ? new float3(0f, 0.012f, 0.005f) : new float3(0f, -0.002f, 0.001f), 0f,
                    isDown ? 0.03 : 0.01, 0, FlightState.Flying));
        }

        var means = FlightMeans.Of(model, moments, new float3(0f, 0.2f, 1.4f));
        int down = moments.Count(at => at.Phase < Math.PI), up = k_Count - down;
        double lift = 0.012 * down - 0.002 * up;
        foreach ((double told, double expected) in new[]
        {
            (means.Speed, 1.5), (means.Climb, 0.25), (means.Error, Math.Sqrt(0.05 * 0.05 + 0.1 * 0.1)), (means.Pitch, moments.Average(at =>
                (0.3 + 0.1 * Math.Cos(at.Phase)) * 180 / Math.PI)),
            (means.PitchBob, 0.1 * 180 / Math.PI), (means.HeightBob, 2.0), (means.Frequency, 10 + 40.0 / 81.0),
                (means.Flap, 1.6 * 180 / Math.PI),
            (means.Lift, lift / k_Count / model.Weight), (means.DownLift, 0.012 / model.Weight), (means.UpSupport, -0.002 * up / lift),
            (means.UpForce, up * Math.Sqrt(5e-6) / (up * Math.Sqrt(5e-6) + down * 0.013)),
                (means.Power, (0.03 * down + 0.01 * up) / k_Count),
            (means.PowerPerMass, (0.03 * down + 0.01 * up) / k_Count / model.Mass),
        })
        {
            Assert.That(told, Is.EqualTo(expected).Within(2e-3 * Math.Abs(expected)));
        }
    }

    [TestCase(0f, "PointPilot")]
    [TestCase(0.1f, "CoursePilot")]
    public void WhatHasATrimForHovering_StaysWhereItIs_AndWhatHasNoneSwimsAbout(float slowest, string kind)
    {
        using var trims = new TrimTable([slowest, 0.5f], [0f]);
        var plan = new FreePlan { Points = [new float3(0f, 0f, 4f)] };

        Assert.That(FreePilot.Hover.Create(plan, trims).GetType().Name, Is.EqualTo(kind));
        Assert.That(FreePilot.GoTo.Create(plan, trims), Is.TypeOf<PointPilot>(), "somewhere else all fly");
        Assert.That(FreePilot.Points.Create(plan, trims), Is.TypeOf<PointPilot>());
        Assert.That(FreePilot.Wander.Create(plan, trims), Is.TypeOf<CoursePilot>());
    }

    // Far away as fast as it may be, near by a time constant, and never so fast that it could not stop.
    [TestCase(0f, 0f, 100f)]
    [TestCase(0f, 0f, 1f)]
    [TestCase(0.2f, 0f, 0.1f)]
    [TestCase(3f, 30f, 4f)]
    [TestCase(3f, -30f, 4f)]
    [TestCase(0f, 0.2f, 3f)]
    public void APilot_FliesToAPoint_AtTheSpeedFromWhichItCanStop(float x, float y, float z)
    {
        var pilot = new PointPilot([new float3(x, y, z) + 1f]);
        FlightCommand told = pilot.Command(new FlightSituation { position = 1f, heading = 0.7f, limits = s_Limits });
        double distance = Math.Sqrt(x * x + y * y + z * z);
        double speed = Math.Min(0.8 * distance, Math.Min(Math.Sqrt(2.5 * distance), 0.9 * 2));

        Assert.That(told.velocity.x, Is.EqualTo(speed * x / distance).Within(1e-4));
        Assert.That(told.velocity.z, Is.EqualTo(speed * z / distance).Within(1e-4));
        Assert.That(told.velocity.y, Is.EqualTo(Math.Clamp(0.8 * y, -0.5, 0.4)).Within(1e-4));
        Assert.That(told.heading, Is.EqualTo(0.7f), "it looks where it looked");
    }

    [Test]
    public void APilotOfManyPoints_FliesOnWhereItIsHalfAMetreNear_AndStaysAtTheLast()
    {
        var pilot = new PointPilot([new float3(0f, 0f, 2f), new float3(3f, 0f, 2f), new float3(3f, 0f, 9f)]);
        float3 Way(float3 position) => pilot.Command(new FlightSituation { position = position, limits = s_Limits }).velocity;

        Assert.That(Way(new float3(0f, 0f, 1.4f)).z, Is.GreaterThan(0.1f), "0.6 m before the first");
        float3 turned = Way(new float3(0f, 0f, 1.6f));
        Assert.That(turned.x, Is.GreaterThan(turned.z), "0.4 m before it the second is next");
        Assert.That(Way(new float3(0f, 0f, 0f)).x, Is.GreaterThan(0.1f), "and stays so");
        Assert.That(Way(new float3(2.8f, 0f, 2f)).z, Is.GreaterThan(0.1f));
        Assert.That(math.length(Way(new float3(3f, 0f, 8.9f))), Is.EqualTo(0.08f).Within(1e-4f), "the last one is not passed");
    }

    [TestCase(10, 0.02, 500)]
    [TestCase(0.3, 0.1, 3)]
    [TestCase(0.25, 0.1, 3)]
    [TestCase(0.7, 0.1, 7)]
    public void AFlight_HasAStepForAllOfItsTime_AndNoneForRounding(double seconds, double step, int steps) =>
        Assert.That(new FreePlan { Seconds = seconds, Step = step }.Steps, Is.EqualTo(steps));

    // The camera goes with the mean of a beat, from half a beat before to half a beat behind.
    [Test]
    public void TheCameraOfAFreeFilm_IsAtTheMeanOfABeat_AndABeatIsLeftBehindTheFilm()
    {
        const int k_Frames = 12, k_Beats = 2;
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        var film = FreeStretch.Fly(
            new FilmPlan { Flight = FlightPlan.Cruise(monarch, InsectVariant.Flight), IsFree = true, Frames = k_Frames, Beats = k_Beats });
        double frequency = TetheredFlight.Fly(FlightPlan.Cruise(monarch, InsectVariant.Flight)).Wings[0].Frequency,
            step = 1 / (frequency * k_Frames);
        FreeRecord record = FreeRun.Fly(
            new FreePlan
            {
                Insect = monarch,
                Pilot = FreePilot.Wander,
                Seed = 1,
                Step = step,
                Seconds = 2 + (k_Beats + 1) * k_Frames * step
            }, _ => { });
        int first = record.Moments.Count - (k_Beats + 1) * k_Frames;
        float3 ahead = math.rotate(record.Moments[first + k_Beats * k_Frames / 2].Rotation, new float3(0f, 0f, 1f));
        var back = quaternion.RotateY(-math.atan2(ahead.x, ahead.z));
        for (int frame = 0; frame < k_Beats * k_Frames; frame++)
        {
            FreeMoment at = record.Moments[first + frame];
            float3 mean = 0f;
            for (int k = first + frame - 6; k < first + frame + 6; k++)
                mean += record.Thorax(record.Moments[k]) / 12f;
            FilmMoment shown = film.At(frame);
            Assert.That(math.distance(shown.Way, math.rotate(back, record.Thorax(at) - mean)), Is.LessThan(1e-5f), $"{frame}");
            Assert.That(shown.Turns, Is.EqualTo(at.Phase / (2 * Math.PI)).Within(1e-9));
            float3[] trail =
            [
                .. Enumerable.Range(first - 3 * k_Frames, 3 * k_Frames + frame)
                    .Select(k => math.rotate(back, record.Thorax(record.Moments[k]) - mean)),
            ];
            Assert.That(shown.Trail, Has.Count.EqualTo(trail.Length), "a dot a frame, from three beats before the film");
            Assert.That(Enumerable.Range(0, trail.Length).Max(k => math.distance(trail[k], shown.Trail[k])), Is.LessThan(1e-5f));
        }
    }
}
