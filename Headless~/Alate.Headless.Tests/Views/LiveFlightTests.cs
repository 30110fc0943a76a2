using System;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Views;

/// <summary>
/// States of a live flight without a server: places, forces, stretches and angles of what is drawn, and the air that the wings meet.
/// </summary>
public sealed class LiveFlightTests
{
    [Test]
    public void AState_HasTheJointsOnTheMesh_AndNothingBeyondItsReach()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        flight.Advance(0.13);
        ViewState state = Read(flight);
        foreach (ViewState.Wing wing in state.Wings[0])
        {
            Assert.That(wing.Places.Max(place => math.length(place)), Is.InRange(0.3f * wing.Reach, wing.Reach));
            foreach (float3 joint in wing.Joints)
                Assert.That(wing.Places.Min(place => math.distance(place, joint)), Is.LessThan(0.004f), "metres");
        }

        float3 right = state.Wings[0][0].Joints[4], left = state.Wings[0][1].Joints[4];
        Assert.That(math.distance(right * new float3(-1f, 1f, 1f), left), Is.LessThan(1e-5f));
        Assert.That(right.x, Is.LessThan(-0.03f), "glTF's X is the insect's left");
        float3 span = state.Wings[0][0].Joints[4] - state.Wings[0][0].Joints[0];
        Assert.That(state.Flap[0], Is.EqualTo(Math.Atan2(span.y, Math.Sqrt(span.x * span.x + span.z * span.z))).Within(1e-4),
            "radians above the horizontal");
        BodyEllipsoid abdomen = InsectCatalogue.Find("monarch").Abdomen;
        double turns = state.Beats[0] - abdomen.lowestPhase / 360.0;
        double up = -abdomen.swing * Math.PI / 180 * Math.Cos(2 * Math.PI * turns);
        Assert.That(state.Abdomen[0], Is.EqualTo(up).Within(1e-4), "radians up");
        Assert.That(state.Substeps[0], Is.EqualTo(flight.Wings[0].Parameters.substepsPerBeat));
        Assert.That(state.Hertz[0], Is.EqualTo(10.086f).Within(0.01f));
    }

    [Test]
    public void TimePasses_AsItIsTold_InSmallStepsAndLarge([Values(0.0007, 0.004, 0.03)] double step)
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        flight.Advance(0.2);
        double before = Read(flight).Beats[0];
        int steps = (int)Math.Round(0.3 / step);
        for (int k = 0; k < steps; k++)
            flight.Advance(step);

        Assert.That(Read(flight).Beats[0] - before, Is.EqualTo(steps * step * flight.Frequency).Within(0.01), "beats");
        Assert.That(flight.Time, Is.EqualTo(0.2 + steps * step).Within(1e-9));
    }

    [Test]
    public void Lift_GoesInStraightLines_FromSubstepToSubstep()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        double substep = 1.0 / (flight.Frequency * flight.Wings[0].Parameters.substepsPerBeat);
        flight.Advance(3.75 * substep);
        float changed = 0f;
        for (int k = 0; k < 20; k++)
        {
            float[] lift = new float[4];
            for (int quarter = 0; quarter < 4; quarter++)
            {
                flight.Advance(0.25 * substep);
                lift[quarter] = Read(flight).Lift[0];
            }

            Assert.That(lift[2] - lift[1], Is.EqualTo(lift[1] - lift[0]).Within(1e-3f));
            Assert.That(lift[3] - lift[2], Is.EqualTo(lift[1] - lift[0]).Within(1e-3f));
            changed = math.max(changed, math.abs(lift[1] - lift[0]));
        }

        Assert.That(changed, Is.GreaterThan(0.01f), "weights");
    }

    [Test]
    public void Loads_AreTheForce_LiftIsUp_DragToTheRear_InWeights()
    {
        FlightPlan plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard) with { Wind = [0, 0, -3] };
        using var flight = new LiveFlight(plan, Insect.Of(plan));
        float drag = 0f, lift = 0f, size = 0f;
        float3 off = 0f;
        for (int k = 0; k < 64; k++)
        {
            flight.Advance(1.0 / (flight.Frequency * flight.Wings[0].Parameters.substepsPerBeat));
            ViewState state = Read(flight);
            float3 sum = 0f;
            foreach (ViewState.Wing wing in state.Wings[0])
            {
                sum += wing.Force;
                off += wing.Loads.Aggregate(-wing.Force, (one, load) => one + load) * (wing == state.Wings[0][0] ? 1f : 0f);
                size += math.length(wing.Force);
            }

            Assert.That(state.Lift[0], Is.EqualTo(sum.y).Within(1e-4f + 1e-4f * math.length(sum)));
            Assert.That(state.Drag[0], Is.EqualTo(-sum.z).Within(1e-4f + 1e-4f * math.length(sum)));
            drag += k < 32 ? 0f : state.Drag[0] / 32f;
            lift += k < 32 ? 0f : state.Lift[0] / 32f;
        }

        Assert.That(math.length(off), Is.LessThan(0.1f * size),
            "the loads of the joints add up to the force of the wing, but for the substep that they are of");
        Assert.That(drag, Is.InRange(0.05f, 50f), "a head wind of 3 m/s and the way ahead push to the rear");
        Assert.That(Math.Abs(lift), Is.LessThan(20f));
    }

    [Test]
    public void AHeadWindOfTheSlider_ComesFromAhead()
    {
        ViewSettings settings = ViewSlider.Set(ViewSettings.Of(InsectCatalogue.Find("monarch"), InsectVariant.Standard), "wind", 2.5);
        FlightPlan plan = settings.Plan(Alate.Catalogue.ComparisonColumn.FullModel);

        Assert.That(plan.Wind, Is.EqualTo(new[] { 0.0, 0.0, -2.5 }));
        Assert.That(plan.AirPastBody.z, Is.EqualTo((float)(-2.5 - settings.Flight.Speed)).Within(1e-6f), "with the speed ahead");
        Assert.That(() => ViewSlider.Set(settings, "wind", 5.01),
            Throws.Exception.With.Message.EqualTo("'wind' must lie between -5 and 5; it is 5.01."));
        Assert.That(ViewSlider.Set(settings, "substeps", 20.4).Flight.Substeps, Is.EqualTo(20));
        foreach (ViewSlider slider in ViewSlider.All)
        {
            foreach (double value in new[] { slider.Min, slider.Max })
                Assert.That(slider.Of(ViewSlider.Set(settings, slider.Name, value)), Is.EqualTo(value), slider.Name);
        }
    }

    [Test]
    [Explicit]
    [Category("Long")]
    public void Gusts_StretchMoreThanStillAir()
    {
        var plan = FlightPlan.Cruise(InsectCatalogue.Find("monarch"), InsectVariant.Standard);
        using var tunnel = new WindTunnel(plan, Insect.Of(plan).Wings[0]);
        WindPoint still = tunnel.Measure(0.0, true), gust = tunnel.Measure(8.0, true), steady = tunnel.Measure(8.0, false);

        Assert.That(gust.StretchMaxPct, Is.GreaterThan(1.15 * still.StretchMaxPct));
        Assert.That(gust.StretchMaxPct, Is.LessThan(3.0 * steady.StretchMaxPct));
        Assert.That(still.HeadBendDeg, Is.InRange(3.0, 20.0), "degrees");
        Assert.That(gust.StretchP99Pct, Is.LessThanOrEqualTo(gust.StretchMaxPct));
        Assert.That((still.Worst, gust.Worst != null), Is.EqualTo(((WindDirection)null, true)));
    }

    // As a message of one column has it.
    private static ViewState Read(LiveFlight flight)
    {
        var buffer = new StateBuffer();
        buffer.Add(0x54414C41u);
        buffer.Add(1u);
        buffer.Add(flight.Time);
        buffer.Add(0u);
        buffer.Add(0u);
        flight.Write(buffer);
        return new ViewState(buffer.Content.ToArray());
    }
}
