using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Flight
{
    /// <summary>
    /// The erratic track: it stays in its volume, is the same for the same seed, and spreads as a correlated random walk does.
    /// </summary>
    public sealed class WanderTests
    {
        private static readonly FlightVolume s_Garden = new FlightVolume(
            VolumeShape.Box, new Vector3(0f, 8f, 0f), new Vector3(50f, 14f, 40f));

        [Test]
        public void Wanderer_StaysWithinItsVolume([Values] VolumeShape shape, [NUnit.Framework.Range(1, 8)] int seed)
        {
            var volume = new FlightVolume(shape, s_Garden.centre, s_Garden.size);
            var flyer = new PointFlyer();
            flyer.situation.position = volume.centre;
            var course = new ErraticCourse(seed);
            for (int step = 0; step < 60 * 50; step++)
            {
                flyer.Fly(FlightCommand.Fly(course.Next(flyer.situation, volume, WanderSettings.Default)));
                Assert.That(
                    volume.Contains(flyer.situation.position), Is.True, $"{flyer.situation.position} after {flyer.situation.time} s");
            }
        }

        [Test]
        public void Wanderer_UsesItsVolume()
        {
            float3 min = float.PositiveInfinity, max = float.NegativeInfinity;
            foreach (float3 place in Track(3, 120f, s_Garden, WanderSettings.Default, 2.5f))
            {
                min = math.min(min, place);
                max = math.max(max, place);
            }

            Assert.That(math.cmin((max - min) / (float3)s_Garden.size), Is.GreaterThan(0.4f), $"{min} to {max}");
        }

        [Test]
        public void Wanderer_OutsideItsVolume_ComesBack()
        {
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(90f, 30f, -70f);
            var course = new ErraticCourse(5);
            for (int step = 0; step < 40 * 50; step++)
                flyer.Fly(FlightCommand.Fly(course.Next(flyer.situation, s_Garden, WanderSettings.Default)));
            Assert.That(s_Garden.Contains(flyer.situation.position), Is.True, $"{flyer.situation.position}");
        }

        [Test]
        public void OneSeed_GivesOneTrack_AnotherAnother()
        {
            List<float3> one = Track(7, 10f, s_Garden, WanderSettings.Default, 2.5f),
                again = Track(7, 10f, s_Garden, WanderSettings.Default, 2.5f);
            Assert.That(again, Is.EqualTo(one));
            Assert.That(math.distance(Track(8, 10f, s_Garden, WanderSettings.Default, 2.5f).Last(), one.Last()), Is.GreaterThan(1f));
        }

        // Kareiva and Shigesada 1983, Eq. 6 for symmetric turns: E(R²) = n E(l²) + 2 E(l)² c/(1-c) (n - (1 - cⁿ)/(1 - c)); l of exponential
        // length with a pace of ±30 %, c = E(cos turn).
        [TestCase(30f)]
        [TestCase(55f)]
        [TestCase(80f)]
        public void NetDisplacement_IsThatOfACorrelatedRandomWalk(float spread)
        {
            const int k_Tracks = 300;
            const float k_Seconds = 14f;
            WanderSettings settings = WanderSettings.Default;
            settings.turnSpread = spread;
            settings.homing = settings.bob = 0f;
            var open = new FlightVolume(VolumeShape.Box, Vector3.zero, 1e6f * Vector3.one);
            double sum = 0.0;
            for (int seed = 1; seed <= k_Tracks; seed++)
            {
                List<float3> track = Track(seed, k_Seconds, open, settings, 400f);
                sum += math.lengthsq((track.Last() - track.First()) / 10f);
            }

            // As many moves as there are on average; the flight ends within the last one.
            double n = k_Seconds / settings.straightTime, c = Math.Exp(-0.5 * Math.Pow(spread * Math.PI / 180.0, 2.0));
            double length = settings.speed * settings.straightTime, squared = 2.0 * length * length * 1.03;
            double expected = n * squared + 2.0 * length * length * c / (1.0 - c) * (n - (1.0 - Math.Pow(c, n)) / (1.0 - c));
            TestContext.Progress.WriteLine(
                FormattableString.Invariant($"spread {spread}°: {sum / k_Tracks:0.0} m², a correlated random walk's {expected:0.0} m²"));
            Assert.That(sum / k_Tracks, Is.EqualTo(expected).Within(20).Percent);
        }

        [Test]
        public void Height_ClimbsAndSinks_OverManyBeats()
        {
            float[] height = Track(
                2, 200f, new FlightVolume(VolumeShape.Box, Vector3.zero, 1e6f * Vector3.one), WanderSettings.Default, 2.5f)
                .Select(place => place.y / 10f).ToArray();
            float[] climb = new float[height.Length - 1];
            for (int k = 0; k < climb.Length; k++)
                climb[k] = (height[k + 1] - height[k]) / 0.02f;
            int changes = Enumerable.Range(1, climb.Length - 1).Count(k => climb[k - 1] * climb[k] < 0f);
            float rms = math.sqrt(climb.Average(c => c * c));
            TestContext.Progress.WriteLine(FormattableString.Invariant($"climb {rms:0.00} m/s rms, {changes / 200f:0.0} changes a second"));
            Assert.That(rms, Is.InRange(0.1f, 0.25f));
            Assert.That(changes / 200f, Is.InRange(0.3f, 2.5f), "slower than a beat of 10 Hz, faster than a walk");
        }

        [Test]
        public void SettingsThatAreNoNumbers_AreTheDefaults()
        {
            var broken = new WanderSettings
            {
                speed = float.NaN,
                straightTime = float.NaN,
                turnSpread = float.NaN,
                homing = float.NaN,
                bob = float.NaN,
                bobTime = float.NaN,
            };
            Assert.That(Track(7, 5f, s_Garden, broken, 2.5f), Is.EqualTo(Track(7, 5f, s_Garden, WanderSettings.Default, 2.5f)));
        }

        private static List<float3> Track(int seed, float seconds, in FlightVolume volume, in WanderSettings settings, float acceleration)
        {
            var flyer = new PointFlyer();
            flyer.situation.limits = new FlightLimits(5f, -0.5f, 0.5f, acceleration);
            flyer.situation.position = volume.centre;
            var course = new ErraticCourse(seed);
            var track = new List<float3>();
            for (int step = 0; step < (int)(seconds / flyer.situation.deltaTime); step++)
            {
                flyer.Fly(FlightCommand.Fly(course.Next(flyer.situation, volume, settings)));
                track.Add(flyer.situation.position);
            }

            return track;
        }
    }
}
