using System.Linq;
using Alate.Catalogue;
using Alate.Cli;
using NUnit.Framework;
using StandIns;
using Unity.Mathematics;

namespace Alate.Tests.Cli;

/// <summary>Flights that commands fly beside the one that was asked for.</summary>
public sealed class FlownBeatTests
{
    [Test]
    public void TheBeatOfAFreeFlight_IsAtTheAttitudeSpeedAndDrive_OfItsMiddle()
    {
        var plan = new FreePlan
        {
            Insect = InsectCatalogue.Find("monarch"),
            Pilot = FreePilot.GoTo,
            Points = [new float3(3f, 1f, 2f)],
            Seconds = 1.2,
        };
        FreeRecord record = FreeRun.Fly(plan, _ => { });
        FreeMoment middle = record.Moments[record.Moments.Count / 2];
        FlightPlan beat = record.Beat.Plan;
        float3 nose = math.rotate(middle.Rotation, new float3(0f, 0f, 1f));

        Assert.That(
            math.sin(math.radians((float)beat.PitchDegrees)), Is.EqualTo(nose.y).Within(1e-5f), "height of the nose over the hinge");
        Assert.That(beat.Speed, Is.EqualTo(math.length(middle.Wanted.xz)), "along, m/s");
        Assert.That(beat.Climb, Is.EqualTo(middle.Wanted.y), "up, m/s");
        Assert.That(middle.Wanted.y, Is.GreaterThan(0.01f), "the way leads up");
        Assert.That(record.Beat.Wings[0].Frequency, Is.EqualTo(middle.Frequency).Within(0.1).Percent);
    }

    [Test]
    public void FlightsAndTimedBeats_LeaveNoNativeMemory()
    {
        var plan = new FlightPlan { Species = "monarch", Speed = 1.0, Substeps = 12 };
        var insect = Insect.Of(plan);
        int before = NativeMemoryLedger.LiveCount;

        TetheredFlight.Fly(plan);
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before), NativeMemoryLedger.Describe());
        BeatCost.SubstepsOf(insect.Wings.First(), plan);
        Assert.That(NativeMemoryLedger.LiveCount, Is.EqualTo(before), NativeMemoryLedger.Describe());
    }

    [TestCase(11.0, 10.0, 10.0)]
    [TestCase(-11.0, -10.0, -10.0)]
    [TestCase(9.0, 10.0, -10.0)]
    public void TheDifferenceFromTheLimit_IsInPercentOfItsSize_AboveNoughtWhereTheDefaultIsMore(double now, double limit, double percent) =>
        Assert.That(new ConvergedValue("lag_deg", "lag, °", now, limit).DifferencePct, Is.EqualTo(percent).Within(1e-9));
}
