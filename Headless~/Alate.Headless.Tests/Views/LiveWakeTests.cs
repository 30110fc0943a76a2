using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;

namespace Alate.Tests.Views;

/// <summary>
/// Wakes that a live flight writes into its states: where they lie and how they turn, when they begin again, and what they leave as it is.
/// </summary>
public sealed class LiveWakeTests
{
    /// <summary>Bytes before the columns of a state.</summary>
    private const int k_Head = 24;

    [Test]
    public void AWake_BeginsAtTheTrailingEdge_AndDriftsToTheRear_TheSameOnBothSides([Values("monarch", "dragonfly")] string species)
    {
        using LiveFlight flight = Start(species);
        Beat(flight, 0.9);
        ViewState state = Read(flight);
        List<ViewState.Sheet> sheets = state.Sheets[0];
        float reach = state.Wings[0].Max(wing => wing.Reach);

        Assert.That(sheets, Has.Count.EqualTo(state.Wings[0].Count));
        for (int k = 0; k < sheets.Count; k++)
        {
            ViewState.Sheet sheet = sheets[k];
            Assert.That(sheet.Width, Is.EqualTo(LiveWake.Panels + 1));
            Assert.That(sheet.Places.Count / sheet.Width, Is.InRange(14, 24), "a row a step but the first two, and the edge");
            Assert.That(sheet.Places, Has.All.Matches<float3>(place => math.length(place) < 4f * reach));
            for (int point = 0; point < sheet.Width; point++)
            {
                Assert.That(
                    state.Wings[0][k].Places.Min(place => math.distance(place, sheet.Places[point])), Is.LessThan(0.02f * reach),
                    "on the wing as it is drawn");
            }

            // Ahead is +Z: three quarters of a beat in air that comes from ahead.
            double way = 0.75 * Plan(species).Speed / flight.Frequency;
            double gone = sheet.Places.Take(sheet.Width).Average(place => place.z) - sheet.Places.TakeLast(sheet.Width)
                .Average(place => place.z);
            Assert.That(gone, Is.InRange(0.5 * way, 2.0 * way), "metres");
            Assert.That(sheet.Circulation.Max(math.abs), Is.InRange(0.05f * sheet.Strongest, 1.0001f * sheet.Strongest));
        }

        for (int k = 0; k < sheets.Count; k += 2)
        {
            Assert.That(sheets[k + 1].Circulation, Is.EqualTo(sheets[k].Circulation), "the air pushes both sides up alike");
            Assert.That(sheets[k].Places.Zip(sheets[k + 1].Places, (right, left) =>
                math.distance(right * new float3(-1f, 1f, 1f), left)), Is.All.LessThan(1e-4f * reach));
            Assert.That(sheets[k].Places.Average(place => place.x), Is.LessThan(0f), "right is -X");
        }
    }

    [Test]
    public void AWake_LeavesTheRestOfAStateAsItIs_AndGoesWhereItIsTurnedOff()
    {
        using LiveFlight flight = Start("monarch"), plain = Start("monarch", hasWake: false);
        for (int k = 0; k < 12; k++)
        {
            Beat(flight, 1.0 / 30.0);
            Beat(plain, 1.0 / 30.0);
            byte[] with = Told(flight), without = Told(plain);
            Assert.That(with, Has.Length.GreaterThan(without.Length));
            Assert.That(with.AsSpan(k_Head, without.Length - k_Head).SequenceEqual(without.AsSpan(k_Head)), Is.True);
        }

        Assert.That(Read(flight).Sheets[0], Is.Not.Empty);
        flight.ShowWake(false);
        Assert.That(Told(flight), Is.EqualTo(Told(plain)));
    }

    [Test]
    public void AWake_BeginsAgain_WhereTheFlightIsAnotherOne_AndGoesOnWhereItIsNot()
    {
        FlightPlan plan = Plan("fishfly");
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        flight.ShowWake(true);
        Beat(flight, 0.5);
        int before = Rows(flight);
        Assert.That(before, Is.InRange(8, 12));
        flight.Change(plan with { Wind = plan.Wind });
        Beat(flight, 0.1);
        Assert.That(Rows(flight), Is.InRange(before + 1, before + 4));

        flight.Change(plan with { Wind = [0.0, 0.0, -1.0] });
        Assert.That(Read(flight).Sheets[0], Is.Empty, "of the other air");
        Beat(flight, 0.3);
        Assert.That(Rows(flight), Is.InRange(3, before), "rows since then alone");
    }

    [Test]
    public void AFlightWithAWake_LeavesNoMemory()
    {
        int live = NativeMemoryLedger.LiveCount;
        using (LiveFlight flight = Start("fishfly"))
            Beat(flight, 0.5);

        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(live), NativeMemoryLedger.Describe());
    }

    // Places of a plate that beats up and down, twice as far in the flight before.
    [Test]
    public void AWakeThatIsRestarted_KnowsNothingOfTheFlightBefore()
    {
        FlightPlan plan = Plan("fishfly");
        using var wings = new TetheredWings(plan, Insect.Of(plan));
        RecordedWing[] right = [.. wings.All.Where(wing => !wing.Placement.IsLeft)];
        var grid = new WakeGrid(right[0], LiveWake.Panels);
        wings.World.Step(1e-4f);
        wings.World.Skin(1f);
        var rest = new float3[grid.Count];
        grid.Take(wings.Vertices(0), wings.FrameOf(0), rest);
        var pace = new WakePace(0.1f, plan.AirInBodyAxes);
        WakeStepper Stepper() => new WakeStepper([right[0]], LiveWake.StepsPerBeat, LiveWake.Panels, true);
        void Fly(WakeStepper stepper, int steps, float height)
        {
            for (int k = 0; k < steps; k++)
            {
                float rise = height * stepper.Length * (float)Math.Sin(2 * Math.PI * k / LiveWake.StepsPerBeat);
                stepper.Step([.. rest.Select(place => place + new float3(0f, rise, 0f))], pace);
            }
        }

        using WakeStepper used = Stepper(), fresh = Stepper();
        Fly(used, 17, 0.6f);
        used.Restart();
        Assert.That(used.Wake, Is.Null);
        Fly(used, 2, 0.3f);
        Assert.That(used.Wake, Is.Null, "speeds of three moments");
        Fly(fresh, 2, 0.3f);
        Fly(used, 9, 0.3f);
        Fly(fresh, 9, 0.3f);
        Assert.That(used.Wake.StepCount, Is.EqualTo(fresh.Wake.StepCount).And.Positive);
        Assert.That(used.Wake.Loads(0).Force, Is.EqualTo(fresh.Wake.Loads(0).Force));
    }

    [Test]
    public void APage_AsksForAWake_AndIsTold()
    {
        using var scene = new SceneInsect(ViewSettings.Of(InsectCatalogue.Find("firefly"), InsectVariant.Standard));
        var state = new StateBuffer();
        scene.Advance(state);
        Assert.That((BitConverter.ToUInt32(state.Content.Span[20..]), (bool)SceneMessage.Settings(scene.Settings)["wake"]),
            Is.EqualTo((0u, false)), "off at first");

        Assert.That(scene.Change(Request("{\"wake\":true}")), Is.False, "the same insect");
        Assert.That((bool)SceneMessage.Settings(scene.Settings)["wake"], Is.True);
        scene.Advance(state);
        Assert.That(new ViewState(state.Content.ToArray()).Length, Is.EqualTo(state.Length));
        Assert.That(BitConverter.ToUInt32(state.Content.Span[20..]), Is.EqualTo(1u));

        ViewSettings other = Request("{\"species\":\"monarch\"}").Apply(scene.Settings);
        Assert.That((other.Species, other.HasWake), Is.EqualTo(("monarch", true)), "stays on with another insect");
        Assert.That(scene.Change(Request("{\"wake\":false}")), Is.False);
        scene.Advance(state);
        Assert.That(BitConverter.ToUInt32(state.Content.Span[20..]), Is.EqualTo(0u));
    }

    [Test]
    public void FastTime_IsFollowedInPieces_WithTheMeanForce()
    {
        using LiveFlight flight = Start("monarch"), plain = Start("monarch", hasWake: false);
        foreach (LiveFlight one in new[] { flight, plain })
        {
            for (int k = 0; k < 3; k++)
            {
                one.Advance(1.3 / one.Frequency);
                Settle(one);
            }
        }

        ViewState with = Read(flight), without = Read(plain);
        Assert.That(with.Beats[0], Is.EqualTo(without.Beats[0]).Within(1e-3));
        Assert.That(with.Lift[0], Is.EqualTo(without.Lift[0]).Within(0.03f * (1f + math.abs(without.Lift[0]))));
        Assert.That(Rows(flight), Is.EqualTo(1 + 37), "the edge, and one and a half beats");
    }

    [Test]
    public void AWake_TakesNoMemoryFromTheFlight()
    {
        using LiveFlight flight = Start("monarch"), plain = Start("monarch", hasWake: false);
        Beat(flight, 1.2);
        Beat(plain, 1.2);
        var buffer = new StateBuffer();
        long Cost(LiveFlight one)
        {
            long least = long.MaxValue;
            for (int k = 0; k < 20; k++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                one.Advance(1.0 / (30.0 * one.Frequency));
                buffer.Clear();
                one.Write(buffer);
                least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
            }

            return least;
        }

        Cost(flight);
        Assert.That(Cost(flight) - Cost(plain), Is.LessThan(200), "bytes a state");
    }

    internal static FlightPlan Plan(string species) => FlightPlan.Cruise(InsectCatalogue.Find(species), InsectVariant.Standard);

    internal static LiveFlight Start(string species, bool hasWake = true)
    {
        FlightPlan plan = Plan(species);
        var flight = new LiveFlight(plan, Insect.Of(plan));
        flight.ShowWake(hasWake);
        return flight;
    }

    // Flies some beats as a page does that shows one a second, and waits for the wake.
    internal static void Beat(LiveFlight flight, double beats)
    {
        int states = (int)Math.Round(30.0 * beats);
        for (int k = 0; k < states; k++)
        {
            flight.Advance(beats / (states * flight.Frequency));
            Settle(flight);
        }
    }

    internal static void Settle(LiveFlight flight) =>
        Assert.That(SpinWait.SpinUntil(() => flight.Wake?.IsIdle ?? true, 10000), Is.True);

    internal static ViewState Read(LiveFlight flight) => new ViewState(Told(flight));

    internal static byte[] Told(LiveFlight flight)
    {
        var buffer = new StateBuffer();
        buffer.Add(0x54414C41u);
        buffer.Add(1u);
        buffer.Add(flight.Time);
        buffer.Add(0u);
        buffer.Add(flight.Wake == null ? 0u : 1u);
        flight.Write(buffer);
        return buffer.Content.ToArray();
    }

    private static int Rows(LiveFlight flight) => Read(flight).Sheets[0].Max(sheet => sheet.Places.Count / sheet.Width);

    private static ViewRequest Request(string text) => ViewRequest.Read(System.Text.Encoding.UTF8.GetBytes(text));
}
