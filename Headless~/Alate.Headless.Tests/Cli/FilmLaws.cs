using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli;
using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>The camera and the trail of films of free flights.</summary>
public sealed class FilmLaws
{
    private const double k_Yaw = 0.4;

    // A way of 3 mm ahead, 2 mm up and 1 mm to the right a frame by the heading of the film's middle, with a bob of one beat.
    private static FreeStretch Stretch(int moments, int beats, int frames)
    {
        int middle = moments - (beats + 1) * frames + beats * frames / 2;
        var flight = new List<FreeMoment>();
        for (int k = 0; k < moments; k++)
        {
            float3 ahead = new((float)Math.Sin(k_Yaw), 0f, (float)Math.Cos(k_Yaw)), right = new(ahead.z, 0f, -ahead.x);
            float bob = (float)Bob(k, frames);
            flight.Add(new FreeMoment
            {
                Position = 0.003f * k * ahead + 0.001f * k * right + new float3(0f, 0.002f * k + bob, 0f),
                Rotation = math.mul(quaternion.RotateY((float)(k_Yaw + 0.01 * (k - middle))), quaternion.RotateX(-0.3f)),
                Phase = 2 * Math.PI * (k % frames) / frames,
            });
        }

        return new FreeStretch(new FilmPlan { Beats = beats, Frames = frames }, new FreeRecord(null, flight, default, 1, null));
    }

    private static double Bob(int k, int frames) => 0.004 * Math.Cos(2 * Math.PI * k / frames);

    [TestCase(100, 2, 16)]
    [TestCase(60, 1, 12)]
    [TestCase(40, 3, 4)]
    public void TheCamera_GoesAlongWithTheMeanOfABeat_SoThatTheBobIsLeft(int moments, int beats, int frames)
    {
        FreeStretch stretch = Stretch(moments, beats, frames);
        for (int frame = 0; frame < beats * frames; frame++)
        {
            FilmMoment at = stretch.At(frame);
            int now = moments - (beats + 1) * frames + frame;
            // The mean of an even number of places lies half a place before the middle one.
            var expected = new float3(0.0005f, (float)(0.001 + Bob(now, frames)), 0.0015f);
            Assert.That(math.distance(at.Way, expected), Is.LessThan(2e-6f), $"{frame}");
            Assert.That(at.Turns, Is.EqualTo((double)(now % frames) / frames).Within(1e-9));
        }
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void AFilmWithAWake_ShowsRings_InEveryFrame_AndHoldsThem()
    {
        var plan = new FilmPlan { Flight = new FlightPlan { Species = "monarch" }, Frames = 4, Beats = 1, Width = 120, HasWake = true };
        var film = Film.Fly(plan);
        UnityEngine.Color32[][] frames = film.Draw(_ => { });
        int width = film.Size.x;
        int[] reds = [.. frames.Select(frame => frame.Count(pixel => pixel.r > pixel.g + 25 && pixel.r < pixel.b + 90))];

        Assert.That(reds, Is.All.GreaterThan(100), "paler than a monarch's orange");
        int[] sides = [.. Enumerable.Range(0, width * film.Size.y).Where(k => k % width is 0 or 119)];
        Assert.That(frames.All(frame => sides.All(k => frame[k].Equals(frame[0]))), "paper at both sides");
        Assert.That(film.Count, Is.EqualTo(4));
    }

    [Test]
    public void TheInsect_LooksAheadInTheMiddleOfTheFilm()
    {
        FreeStretch stretch = Stretch(100, 2, 16);
        foreach (int frame in new[] { 0, 16, 31 })
        {
            float3 nose = math.rotate(stretch.At(frame).Turn, new float3(0f, 0f, 1f));
            double yaw = 0.01 * (frame - 16);
            Assert.That(nose.y, Is.EqualTo(Math.Sin(0.3)).Within(1e-5), "the pitch is left");
            Assert.That(nose.x, Is.EqualTo(Math.Cos(0.3) * Math.Sin(yaw)).Within(1e-5));
            Assert.That(nose.z, Is.EqualTo(Math.Cos(0.3) * Math.Cos(yaw)).Within(1e-5));
        }
    }

    // Twice one moment, first seen from a side and then from another: the way back has the same pictures the other way round.
    [Test]
    public void ATurn_GoesRoundTheInsect_AndBackByItsNegative()
    {
        var there = new FilmPlan { Flight = new FlightPlan { Species = "firefly", Seconds = 0.2 }, Frames = 1, Turn = 100, Width = 160 };
        PictureView view = there.Flight.View;
        FilmPlan back = there with { Flight = there.Flight with { View = view with { Aside = view.Aside + 50f } }, Turn = -100 };
        UnityEngine.Color32[][] one = Film.Fly(there).Draw(_ => { }), other = Film.Fly(back).Draw(_ => { });

        Assert.That(one, Has.Length.EqualTo(2));
        Assert.That(one[0], Is.Not.EqualTo(one[1]));
        Assert.That(one[0], Is.EqualTo(other[1]));
        Assert.That(one[1], Is.EqualTo(other[0]));
    }

    // Eight dots a beat over three beats before the film, or from the start of the flight, and on up to the frame.
    [TestCase(100, 2, 16, 0, 4, 2)]
    [TestCase(100, 2, 16, 7, 4, 2)]
    [TestCase(56, 2, 16, 0, 0, 2)]
    [TestCase(40, 3, 4, 2, 12, 1)]
    public void TheTrail_HasDotsWhereTheThoraxWas(int moments, int beats, int frames, int frame, int first, int between)
    {
        int now = moments - (beats + 1) * frames + frame;
        FilmMoment at = Stretch(moments, beats, frames).At(frame);
        int[] places = [.. Enumerable.Range(first, now - first).Where(k => k % between == 0)];

        Assert.That(at.Trail, Has.Count.EqualTo(places.Length));
        for (int k = 0; k < places.Length; k++)
        {
            int back = places[k] - now;
            var expected = new float3(0.001f * back, (float)(0.002 * back + Bob(places[k], frames) - Bob(now, frames)), 0.003f * back);
            Assert.That(math.distance(at.Trail[k] - at.Way, expected), Is.LessThan(2e-6f));
        }
    }

    [Test]
    public void AFilmOfAFreeFlight_HasAsManyFramesOfABeatAsItIsTold()
    {
        var stretch = FreeStretch.Fly(new FilmPlan { Flight = new FlightPlan { Species = "monarch" }, Beats = 2, Frames = 8 });
        double[] turns = [.. Enumerable.Range(0, 16).Select(frame => stretch.At(frame).Turns)];

        Assert.That(turns, Is.All.InRange(0.0, 1.0));
        for (int k = 1; k < turns.Length; k++)
            Assert.That(turns[k] - turns[k - 1] - Math.Floor(turns[k] - turns[k - 1]), Is.EqualTo(1.0 / 8).Within(0.03));
        FilmMoment start = stretch.At(0);
        Assert.That(start.Trail, Has.Count.EqualTo(3 * 8));
        // A monarch under way makes 0.5 m/s at least, and ten beats a second.
        Assert.That(math.distance(start.Trail[0], start.Way), Is.InRange(0.1f, 1f));
        Assert.That(math.length(start.Way), Is.LessThan(0.03f), "the camera goes along");
        Assert.That(stretch.Beat.Insect.Name, Is.EqualTo("monarch"));
    }

    // A free flight steps by a millisecond at least, and by a twentieth of a second at most.
    [TestCase("firefly", 40, 0.001)]
    [TestCase("snailfish", 4, 0.05)]
    public void AFrameOfAFreeFilm_IsNoShorterAndNoLongerThanAStepMayBe(string species, int frames, double step)
    {
        var film = FreeStretch.Fly(new FilmPlan { Flight = new FlightPlan { Species = species }, Beats = 1, Frames = frames });
        double frequency = film.Beat.Wings[0].Frequency, turns = film.At(1).Turns - film.At(0).Turns;

        Assert.That(turns - Math.Floor(turns), Is.EqualTo(frequency * step).Within(15).Percent);
    }

    // Beats that answer along a line, lack = b − c v: the share of Aitken's rule is the one that ends it, 1/c, between 0.05 and 1.
    [TestCase(2.0, 0.5)]
    [TestCase(5.0, 0.2)]
    [TestCase(0.5, 1.0)]
    [TestCase(100.0, 0.05)]
    [TestCase(-1.0, 0.05)]
    public void TheShareOfAMove_IsThatWhichEndsALinearLack(double slope, double share)
    {
        const float k_Last = 0.5f;
        var before = new float3(0.3f, -0.8f, 0.2f);
        float3 now = before - (float)slope * k_Last * before;

        Assert.That(InducedStream.Share(k_Last, before, now), Is.EqualTo(share).Within(1e-5));
        Assert.That(InducedStream.Share(k_Last, default, now), Is.EqualTo(k_Last), "there is no move before");
        Assert.That(InducedStream.Share(k_Last, before, before), Is.EqualTo(k_Last), "nothing changed");
    }

    // Of the change, only what lies along the lack counts.
    [Test]
    public void AChangeAcrossTheLack_MakesTheShareSmaller()
    {
        var before = new float3(1f, 0f, 0f);

        Assert.That(InducedStream.Share(0.5f, before, new float3(0.5f, 0.5f, 0f)), Is.EqualTo(0.5f).Within(1e-6f), "0.5 · 0.5 / 0.5");
        Assert.That(InducedStream.Share(0.5f, before, new float3(0.5f, 0f, 1f)), Is.EqualTo(0.2f).Within(1e-6f), "0.5 · 0.5 / 1.25");
    }
}
