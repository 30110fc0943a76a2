using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class BeatClockTests
    {
        [TestCase(0.25f)]
        [TestCase(0.9f)]
        public void Slope_IsThatOfFigure5(float relativeSpeed)
        {
            double expected = Sigmoid(relativeSpeed);
            Assert.That(BeatClock.Slope(relativeSpeed).x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        // 11 Hz at most, at 2 m/s; its floor is four fifths of that.
        [TestCase(1.3f)]
        [TestCase(0f)]
        public void Frequency_IsLatchedFromTheSpeed(float speed)
        {
            double expected = 11.0 * Math.Max(Sigmoid(speed / 2.0), 0.8);
            LaneParameters parameters = Lanes.Parameters(WingParameters.Default);
            LaneSurroundings air = default;
            air.speed = speed;
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, air, true);
            Assert.That(beat.frequency.x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void RestingInsect_BeatsAtHalfAmplitude()
        {
            LaneParameters parameters = Lanes.Parameters(WingParameters.Default);
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, default, true);
            Assert.That(beat.amplitude.x.x, Is.EqualTo(0.5 * parameters.amplitude.x.x).Within(1e-6));
        }

        [Test]
        public void SteepBody_BeatsHard_AndKeepsDoingSoWithinTheHysteresis()
        {
            WingParameters slow = WingParameters.Default;
            slow.frequencyFloor = 0f;
            LaneParameters parameters = Lanes.Parameters(slow);
            LaneSurroundings air = default;
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, air, true);
            Assert.That(beat.frequency.x, Is.LessThan(0.01f), "level and at rest");

            air.pitch = math.radians(33f);
            FinishCycle(ref beat, parameters, air);
            Assert.That(beat.frequency.x, Is.EqualTo(0.85f * slow.maxFrequency).Within(1e-4), "pitched up");

            air.pitch = math.radians(29f);
            FinishCycle(ref beat, parameters, air);
            Assert.That(beat.frequency.x, Is.EqualTo(0.85f * slow.maxFrequency).Within(1e-4), "a little below the threshold");

            air.pitch = math.radians(27f);
            FinishCycle(ref beat, parameters, air);
            Assert.That(beat.frequency.x, Is.LessThan(0.01f), "clearly below the threshold");
        }

        [Test]
        public void Frequency_ChangesOnlyAtTheStartOfACycle()
        {
            LaneParameters parameters = Lanes.Parameters(WingParameters.Default);
            LaneSurroundings air = default;
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, air, true);
            air.speed = 2f;
            BeatClock.Advance(ref beat, parameters, air, CycleChange.Smooth, 0.05f);
            Assert.That(beat.frequency.x, Is.EqualTo(8.8f).Within(1e-4));
            BeatClock.Advance(ref beat, parameters, air, CycleChange.Smooth, 0.08f);
            Assert.That(beat.cycles.x, Is.EqualTo(1f));
            Assert.That(beat.frequency.x, Is.GreaterThan(10.9f));
            Assert.That(beat.previousFrequency.x, Is.EqualTo(8.8f).Within(1e-4));
        }

        [Test]
        public void Latching_OfOneWing_LeavesItsNeighboursAlone()
        {
            LaneParameters parameters = Lanes.Parameters(WingParameters.Default);
            LaneSurroundings air = default;
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, air, true);
            beat.phase = new float4(6.2f, 1f, 2f, 3f);
            air.speed = 2f;
            air.pitch = math.radians(40f);
            BeatClock.Advance(ref beat, parameters, air, CycleChange.Smooth, 0.005f);
            Assert.That(beat.cycles, Is.EqualTo(new float4(1f, 0f, 0f, 0f)));
            Assert.That(beat.frequency.y, Is.EqualTo(8.8f).Within(1e-4));
            Assert.That(beat.pitchedUp, Is.EqualTo(new float4(1f, 0f, 0f, 0f)));
        }

        // Four beats back: the latest delays ask for them.
        [Test]
        public void AReset_ForgetsAllBeatsOfTheChosenWings_AndAddsABeatToNoOther()
        {
            LaneParameters parameters = Lanes.Parameters(WingParameters.Default);
            LaneSurroundings air = default;
            BeatState beat = default;
            BeatClock.Reset(ref beat, parameters, air, true);
            SoaFloat3 fresh = beat.amplitude;
            for (int round = 0; round < 5; round++)
            {
                air.speed = 0.5f * round;
                FinishCycle(ref beat, parameters, air);
            }

            BeatState flown = beat;
            air = default;
            BeatClock.Reset(ref beat, parameters, air, new bool4(true, false, true, false));
            SoaFloat3[] now = { beat.amplitude, beat.amplitude1, beat.amplitude2, beat.amplitude3, beat.amplitude4 };
            SoaFloat3[] before = { flown.amplitude, flown.amplitude1, flown.amplitude2, flown.amplitude3, flown.amplitude4 };
            for (int back = 0; back < now.Length; back++)
            {
                for (int lane = 0; lane < 4; lane++)
                {
                    float3 expected = lane % 2 == 0 ? fresh[lane] : before[back][lane];
                    Assert.That(now[back][lane], Is.EqualTo(expected), $"{back} beats back, lane {lane}");
                }
            }

            Assert.That(math.distance(before[0][0], before[4][0]), Is.GreaterThan(1e-3f), "beats differ");
        }

        private static double Sigmoid(double share) => 1.0 / (1.0 + Math.Exp(-16.0 * (share - 0.5)));

        private static void FinishCycle(ref BeatState beat, in LaneParameters parameters, in LaneSurroundings air)
        {
            beat.phase = 2f * math.PI;
            BeatClock.Advance(ref beat, parameters, air, CycleChange.Smooth, 0f);
        }
    }
}
