using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Views;

/// <summary>Parts of a live wake: the motion of its wings by closed forms, the moments that wait, the wake beside the record's.</summary>
public sealed class FlownWakeTests
{
    private const int k_Beat = 24;

    [Test]
    public void AMotion_IsThatOfTheBeat_OnceItIsKnown_AndByDifferencesBefore()
    {
        // Two rows of two, and a place in their middle.
        var wing = new FlownWing(k_Beat, 2, 2);
        float2[] places = [new(0f, 0f), new(0f, 1f), new(1f, 0f), new(1f, 1f), new(0.5f, 0.5f)];
        var points = new float3[5];
        var velocities = new float3[5];
        float3 Mean(Func<int, float3> of) => 0.25f * (of(0) + of(1) + of(2) + of(3));
        for (int moment = 0; moment < 3 * k_Beat; moment++)
        {
            wing.Move([At(moment, 0), At(moment, 1), At(moment, 2), At(moment, 3)], 2f);
            Assert.That(wing.IsKnown, Is.EqualTo(moment >= 2));
            wing.Evaluate(0.0, places, points, velocities);
            for (int k = 0; k < 5 && moment >= 2; k++)
            {
                bool isWhole = moment + 1 >= k_Beat;
                float3 at = k < 4 ? At(moment, k) : Mean(n => At(moment, n));
                float3 rate = k < 4 ? RateAt(moment, k) : Mean(n => RateAt(moment, n));
                Assert.That(math.distance(points[k], 2f * at), Is.LessThan(1e-4f));
                Assert.That(math.distance(velocities[k], 2f * rate), Is.LessThan(isWhole ? 2e-3f : 1.5f), "of up to 21");
            }
        }
    }

    [Test]
    public void AMotionInTriangles_BetweenSubsteps_IsSmooth()
    {
        // Straight between 16 substeps of a beat, as drawn wings are: the velocity of the sine, less what chords leave of it.
        var wing = new FlownWing(k_Beat, 2, 2);
        var velocity = new float3[1];
        float worst = 0f;
        for (int moment = 0; moment < 2 * k_Beat; moment++)
        {
            double turn = (double)moment / k_Beat, substep = Math.Floor(16.0 * turn) / 16.0, share = 16.0 * (turn - substep);
            double between = (1.0 - share) * Math.Sin(2.0 * Math.PI * substep) + share * Math.Sin(2.0 * Math.PI * (substep + 1.0 / 16.0));
            float3 place = new((float)between, 0f, 0f);
            wing.Move([place, place, place, place], 1f);
            wing.Evaluate(0.0, new float2[1], new float3[1], velocity);
            if (moment >= k_Beat)
                worst = math.max(worst, (float)Math.Abs(velocity[0].x - 2.0 * Math.PI * Math.Cos(2.0 * Math.PI * turn)));
        }

        Assert.That(worst, Is.LessThan(0.03f * 2f * math.PI));
    }

    [Test]
    public void MomentsThatWaitTooLong_AreLeftOutByWholeBeats()
    {
        var moments = new WakeMoments(k_Beat, 1);
        var taken = new List<long>();
        var places = new float3[1];
        var random = new System.Random(5);
        for (long index = 0; index < 3000; index++)
        {
            moments.Next[0] = new float3(index, 0f, 0f);
            moments.Add(index);
            // Two moments taken of three added, in bursts.
            for (int k = random.Next(0, 5); k >= 3 && moments.TryTake(places, out long next); k--)
            {
                Assert.That(places[0].x, Is.EqualTo(next));
                taken.Add(next);
            }

            Assert.That(moments.Count, Is.InRange(0, 2 * k_Beat));
        }

        Assert.That(taken, Is.Not.Empty);
        Assert.That(taken.Zip(taken.Skip(1), (one, next) => (next - one, (next - one) % k_Beat)),
            Has.All.Matches<(long Way, long Phase)>(way => way.Way >= 1 && way.Phase == 1), "the next one, or that of a later beat");
        Assert.That(taken[^1], Is.GreaterThan(3000 - 3 * k_Beat));
        moments.Clear();
        Assert.That(moments.TryTake(places, out _), Is.False);
    }

    [Test]
    public void AWingWithAGap_ShedsNone_InOneLine()
    {
        float3[] rest = [new(0f, 0f, 0f), new(0.4f, 0f, 0f), new(0.4f, 0f, 0.2f), new(0.6f, 0f, 0f), new(1f, 0f, 0f), new(1f, 0f, 0.2f)];
        RecordedWing Wing(params int[] triangles) => new RecordedWing
        {
            Placement = new WingMount(new float3(0.1f, 0f, 0f), 0.05f, WingSide.Left),
            Rest = rest,
            Triangles = triangles,
        };

        Assert.That(() => new WakeGrid(Wing(0, 2, 1, 3, 5, 4), 10), Throws.TypeOf<UserException>().With.Message.EqualTo(
            "This wing sheds no wake. The wing has no chord at 0.401 of its span."));
        var grid = new WakeGrid(Wing(0, 2, 1, 1, 2, 3, 3, 5, 4), 10);
        Assert.That((grid.Stations, grid.Count), Is.EqualTo((11, 22)));
        Assert.That(math.distance(grid.TrailingEdge(5, rest), new float3(-0.125f, 0f, 0f)), Is.LessThan(1e-4f), "metres, on the left");
    }

    [Test, Explicit, Category("Long")]
    public void ASettledWake_IsThatOfTheRecordedBeat([Values("monarch", "dragonfly", "fishfly")] string species)
    {
        FlightPlan plan = LiveWakeTests.Plan(species);
        using var record = new WakeFlight(
            TetheredFlight.Fly(plan), new WakePlan { Beats = 4, Keep = 1.5, FarCore = 0.8, SpanPanels = LiveWake.Panels });
        record.Run(_ => { });
        // At the end of its last step, a 24th before the end of the beat.
        double phase = (LiveWake.StepsPerBeat - 1.0) / LiveWake.StepsPerBeat;
        using LiveFlight flight = LiveWakeTests.Start(species);
        LiveWakeTests.Beat(flight, 11.0);
        ViewState state = LiveWakeTests.Read(flight);
        while (state.Beats[0] - Math.Floor(state.Beats[0]) - phase is < 0.0 or > 0.001)
        {
            flight.Advance(0.0005 / flight.Frequency);
            LiveWakeTests.Settle(flight);
            state = LiveWakeTests.Read(flight);
        }

        for (int k = 0; k < record.Wings.Count; k++)
        {
            var told = ShapedSheet.Of(record.Wake.Sheet(k), record.Length, record.Period, false);
            ViewState.Sheet sheet = state.Sheets[0][2 * k];
            float off = 0f, largest = 0f, gap = 0f;
            int rows = Math.Min(told.Rows, LiveWake.StepsPerBeat / 2);
            for (int at = 0; at < rows * told.Width; at++)
            {
                float3 point = sheet.Places[at + sheet.Width] * new float3(-1f, 1f, 1f);
                off += math.distance(point, told.Points[at]) / (rows * told.Width * (float)record.Length);
                float circulation = told.CirculationAt(at / told.Width, at % told.Width);
                gap = math.max(gap, math.abs(sheet.Circulation[at + sheet.Width] - circulation));
                largest = math.max(largest, math.abs(circulation));
            }

            TestContext.Out.WriteLine($"{species} {k}: points off by {off:0.0000} wing lengths, circulation by {gap / largest:0.000}");
            Assert.That(off, Is.LessThan(0.02f), "wing lengths, mean of half a beat");
            Assert.That(gap, Is.LessThan(0.15f * largest), "m²/s");
        }
    }

    private static float3 At(int moment, int place)
    {
        float turn = 2f * math.PI * moment / k_Beat + place;
        return new float3(math.sin(turn), 0.3f * math.cos(2f * turn), place + 0.1f * math.sin(3f * turn));
    }

    private static float3 RateAt(int moment, int place)
    {
        float turn = 2f * math.PI * moment / k_Beat + place;
        return 2f * math.PI * new float3(math.cos(turn), -0.6f * math.sin(2f * turn), 0.3f * math.cos(3f * turn));
    }
}
