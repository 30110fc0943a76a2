using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Speeds before the rim of a volume, within it and beyond it.</summary>
    public sealed class VolumeLaws
    {
        private static readonly FlightLimits s_Limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f);

        // As fast as the insect can stop 0.1 m before the rim; from there on, and beyond it, back in, at most at half of its top speed.
        [Test]
        public void ABox_IsBrakedBefore_OnEverySide(
            [Values(0, 1, 2)] int axis, [Values(-1f, 1f)] float side, [Values(-3f, -0.2f, 0.05f, 0.12f, 0.3f, 0.9f)] float left,
                [Values(1f, 10f)] float units)
        {
            var volume = new FlightVolume(VolumeShape.Box, new Vector3(1f, 2f, 3f), units * new Vector3(8f, -6f, 10f));
            float3 place = default, wanted = 0.2f;
            place[axis] = side * (0.5f * math.abs(volume.size[axis]) - units * left);
            wanted[axis] = 1.1f * side;
            float3 held = volume.Hold(wanted, (float3)volume.centre + place, s_Limits, units);
            float room = left - 0.1f, most = room >= 0f ? s_Limits.SpeedToStopWithin(room)
                : -math.min(s_Limits.SpeedToStopWithin(-room), 0.65f);
            float3 expected = wanted;
            expected[axis] = side * math.min(1.1f, most);
            Assert.That(math.distance(held, expected), Is.LessThan(1e-4f));
            wanted[axis] = -1.1f * side;
            Assert.That(volume.Hold(wanted, (float3)volume.centre + place, s_Limits, units), Is.EqualTo(wanted), "inwards as it likes");
        }

        // A size of 0 counts as the least one: its middle is within, and the way there is a velocity.
        [Test]
        public void AVolumeWithoutASize_IsFlownTo([Values] VolumeShape shape, [Values(0, 1, 2, 3)] int flat)
        {
            Vector3 size = 4f * Vector3.one;
            for (int axis = 0; axis < 3; axis++)
                size[axis] = flat == axis || flat == 3 ? 0f : size[axis];
            var volume = new FlightVolume(shape, new Vector3(1f, 2f, 3f), size);
            Assert.That(volume.Contains((float3)volume.centre));
            Assert.That(volume.Contains((float3)volume.centre + 0.5f), Is.False);
            for (int axis = 0; axis < 3; axis++)
            {
                float3 off = default;
                off[axis] = 3f;
                float3 held = volume.Hold(off, (float3)volume.centre + off, s_Limits, 1f);
                Assert.That(math.all(math.isfinite(held)), $"{held}");
                Assert.That(held[axis], Is.Negative, "back in");
                Assert.That(math.all(math.isfinite(volume.Hold(off, volume.centre, s_Limits, 1f))));
            }
        }

        [Test]
        public void OfASmallBox_AQuarterIsLeftAtTheRim()
        {
            var volume = new FlightVolume(VolumeShape.Box, Vector3.zero, 0.4f * Vector3.one);
            float3 held = volume.Hold(new float3(1f, 0f, 0f), new float3(0.1f, 0f, 0f), s_Limits, 1f);
            Assert.That(held.x, Is.EqualTo(s_Limits.SpeedToStopWithin(0.05f)).Within(1e-4f));
        }

        // Looked ahead 0.3 s, where the rim may have bent inwards.
        [Test]
        public void ABall_IsBrakedBefore_WhateverTheDirection([Values(0.5f, 0.9f, 1.4f, 2f)] float left, [Values(1f, 10f)] float units)
        {
            var volume = new FlightVolume(VolumeShape.Ellipsoid, new Vector3(1f, 2f, 3f), 8f * units * Vector3.one);
            foreach (uint seed in Seeds.First(20))
            {
                var random = new Random(seed);
                float3 outward = random.NextFloat3Direction();
                float3 held = volume.Hold(1.2f * outward, (float3)volume.centre + units * (4f - left) * outward, s_Limits, units);
                float first = math.min(1.2f, s_Limits.SpeedToStopWithin(left - 0.1f)), room = left - 0.1f - 0.3f * first;
                float second = room >= 0f ? s_Limits.SpeedToStopWithin(room) : -s_Limits.SpeedToStopWithin(-room);
                Assert.That(math.distance(held, math.min(first, second) * outward), Is.LessThan(1e-3f));
            }
        }

        [Test]
        public void InTheMiddle_NothingIsHeld([Values] VolumeShape shape)
        {
            var volume = new FlightVolume(shape, Vector3.one, 20f * Vector3.one);
            float3 wanted = math.normalize(new float3(1f, 2f, 3f));
            Assert.That(math.distance(volume.Hold(wanted, 1f, s_Limits, 1f), wanted), Is.LessThan(1e-6f));
        }

        [Test]
        public void AVolume_ContainsWhatIsWithinItsHalfSizes([Values(0, 1, 2)] int axis, [Values(-1f, 1f)] float side)
        {
            var box = new FlightVolume(VolumeShape.Box, new Vector3(5f, 6f, 7f), new Vector3(2f, 4f, -6f));
            var ball = new FlightVolume(VolumeShape.Ellipsoid, box.centre, box.size);
            float3 half = new float3(1f, 2f, 3f), within = box.centre, beyond = box.centre;
            within[axis] += 0.99f * side * half[axis];
            beyond[axis] += 1.01f * side * half[axis];
            Assert.That(box.Contains(within) && ball.Contains(within));
            Assert.That(box.Contains(beyond) || ball.Contains(beyond), Is.False);
            Assert.That(box.Contains((float3)box.centre + 0.6f * half * side), "a corner");
            Assert.That(ball.Contains((float3)box.centre + 0.6f * half * side), Is.False, "which no ellipsoid has");
            Assert.That(ball.Contains((float3)box.centre + 0.57f * half * side), Is.True);
        }
    }
}
