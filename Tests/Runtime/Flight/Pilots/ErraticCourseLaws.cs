using System.Collections.Generic;
using System.Linq;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Flight
{
    /// <summary>Numbers of an erratic track: what its settings say is what is measured on it.</summary>
    public sealed class ErraticCourseLaws
    {
        private const float k_Step = 0.02f;

        private static readonly FlightVolume s_Open = new FlightVolume(VolumeShape.Box, Vector3.zero, 1e6f * Vector3.one);

        // Straight on and level the speed alone changes: from stretch to stretch, evenly within 30 % of the mean, or 80 % where erratic.
        [TestCase(0f, 0.3f)]
        [TestCase(0.4f, 0.5f)]
        [TestCase(1f, 0.8f)]
        public void Speeds_AreWithinThirtyPercentOfTheMean_OrMoreWhereErratic(float erratic, float spread)
        {
            WanderSettings settings = Straight(4f);
            settings.speed = 0.7f;
            settings.erratic = erratic;
            float[] speeds = Plateaus(Track(settings, 4000f), v => math.length(v));
            Assert.That(speeds.Min(), Is.InRange((1f - spread) * 0.7f - 1e-3f, (1.03f - spread) * 0.7f));
            Assert.That(speeds.Max(), Is.InRange((0.97f + spread) * 0.7f, (1f + spread) * 0.7f + 1e-3f));
            Assert.That(speeds.Average(), Is.EqualTo(0.7f).Within(0.03f));
        }

        // A few stretches are over before their speed is reached.
        [TestCase(2f, 0f)]
        [TestCase(4f, 1f)]
        [TestCase(2f, 1f, Explicit = true, Category = "Long")]
        [TestCase(4f, 0f, Explicit = true, Category = "Long")]
        public void Stretches_LastTheirTimeOnAverage_OrHalfOfItWhereErratic(float time, float erratic)
        {
            WanderSettings settings = Straight(time);
            settings.erratic = erratic;
            int stretches = Plateaus(Track(settings, 4000f), v => math.length(v)).Length;
            float expected = (1f - 0.5f * erratic) * time;
            Assert.That(4000f / stretches, Is.EqualTo(1.08f * expected).Within(0.15f * expected));
        }

        [TestCase(15f, 0f)]
        [TestCase(30f, 1f)]
        [TestCase(15f, 1f, Explicit = true, Category = "Long")]
        [TestCase(30f, 0f, Explicit = true, Category = "Long")]
        public void Turns_HaveTheirSpread_AndThreeTenthsMoreWhereErratic(float degrees, float erratic)
        {
            WanderSettings settings = Straight(4f * (1f + erratic));
            settings.turnSpread = degrees;
            settings.erratic = erratic;
            degrees *= 1f + 0.3f * erratic;
            float[] courses = Plateaus(Track(settings, 8000f), v => math.atan2(v.x, v.z));
            float sum = 0f, mean = 0f;
            for (int k = 1; k < courses.Length; k++)
            {
                float turn = Headings.Wrap(courses[k] - courses[k - 1]);
                sum += turn * turn;
                mean += turn / courses.Length;
            }

            Assert.That(math.degrees(math.sqrt(sum / courses.Length)), Is.EqualTo(degrees).Within(0.12f * degrees));
            Assert.That(math.degrees(mean), Is.Zero.Within(0.1f * degrees), "to either side");
        }

        // An Ornstein-Uhlenbeck process: its spread is the setting's, and after its time it remembers 1/e, whatever the step.
        [Test]
        public void Climb_HasItsSpread_AndItsTime([Values(0.02f, 0.1f)] float dt)
        {
            WanderSettings settings = Straight(20f);
            settings.bob = 0.06f;
            settings.bobTime = 1f;
            float[] climb = Track(settings, 4000f, dt).Select(v => v.y).ToArray();
            int lag = (int)math.round(1f / dt);
            double square = 0, together = 0;
            for (int k = 0; k + lag < climb.Length; k++)
            {
                square += climb[k] * climb[k];
                together += climb[k] * climb[k + lag];
            }

            Assert.That(math.sqrt(square / (climb.Length - lag)), Is.EqualTo(0.06).Within(0.006));
            Assert.That(together / square, Is.EqualTo(math.exp(-1f)).Within(0.1));
        }

        [Test]
        public void Climb_StaysWithinTheInsects()
        {
            WanderSettings settings = Straight(20f);
            settings.bob = 1f;
            float[] climb = Track(settings, 400f).Select(v => v.y).ToArray();
            Assert.That(climb.Min(), Is.EqualTo(-0.3f).Within(1e-4f));
            Assert.That(climb.Max(), Is.EqualTo(0.2f).Within(1e-4f));
        }

        [TestCase(0f, 0.4f, 0.45f)]
        [TestCase(1f, 1f, 1f)]
        public void NoTurn_AndNoChange_IsFasterThanItsShareOfTheInsects(float erratic, float turns, float changes)
        {
            WanderSettings settings = WanderSettings.Default;
            settings.turnSpread = 150f;
            settings.speed = 1.2f;
            settings.erratic = erratic;
            FlightSituation situation = Situation(k_Step);
            var course = new ErraticCourse(3);
            float turning = 0f, change = 0f;
            float3 last = course.Next(situation, s_Open, settings);
            for (int step = 0; step < 5000; step++)
            {
                float before = course.Course;
                float3 now = course.Next(situation, s_Open, settings);
                turning = math.max(turning, math.abs(Headings.Wrap(course.Course - before)) / k_Step);
                change = math.max(change, math.length(now - last) / k_Step);
                last = now;
            }

            Assert.That(turning, Is.EqualTo(turns * situation.limits.TurnRate(1.2f)).Within(0.01f));
            Assert.That(change, Is.EqualTo(changes * 2.5f).Within(0.01f));
        }

        // Four fifths of the fastest turn, a/v of the top speed, whose radius is half of the half of the narrower side.
        [TestCase(2f, 1f)]
        [TestCase(1f, 1f)]
        [TestCase(2f, 4f)]
        public void InANarrowVolume_NobodyIsFasterThanATurnBackAllows(float narrow, float unitsPerMetre)
        {
            FlightSituation situation = Situation(k_Step);
            situation.unitsPerMetre = unitsPerMetre;
            WanderSettings settings = Straight(20f);
            settings.speed = 5f;
            var course = new ErraticCourse(3);
            var volume = new FlightVolume(VolumeShape.Box, Vector3.zero, new Vector3(100f, 100f, narrow));
            float fastest = 0f;
            for (int step = 0; step < 2000; step++)
                fastest = math.max(fastest, math.length(course.Next(situation, volume, settings).xz));
            Assert.That(fastest, Is.EqualTo(0.5f * 0.5f * narrow / unitsPerMetre * 0.8f * 2.5f / 1.3f).Within(0.5f).Percent);
        }

        // Towards the rim the insect turns back, twice as fast, to within 1 rad of the way home.
        [Test]
        public void BeforeTheRim_TheCourseTurnsHome([Values(1, 2, 3, 4, 5)] int seed, [Values(0f, 1f)] float erratic)
        {
            var volume = new FlightVolume(VolumeShape.Box, Vector3.zero, new Vector3(20f, 20f, 20f));
            FlightSituation situation = Situation(k_Step);
            situation.position = new float3(0f, 0f, 9f);
            var course = new ErraticCourse(seed);
            WanderSettings settings = Straight(20f);
            settings.erratic = erratic;
            float turning = 0f;
            for (int step = 0; step < 150; step++)
            {
                float before = course.Course;
                course.Next(situation, volume, settings);
                turning = math.max(turning, math.abs(Headings.Wrap(course.Course - before)) / k_Step);
            }

            Assert.That(math.abs(Headings.Wrap(course.Course - math.PI)), Is.LessThan(1.01f));
            Assert.That(turning, Is.EqualTo((erratic > 0f ? 1f : 0.8f) * situation.limits.TurnRate(1f)).Within(0.01f));
        }

        [Test]
        public void ARestartedCourse_BeginsWhereTheInsectIs()
        {
            var course = new ErraticCourse(2);
            FlightSituation situation = Situation(k_Step);
            for (int step = 0; step < 100; step++)
                course.Next(situation, s_Open, WanderSettings.Default);
            course.Restart();
            situation.heading = 1.5f;
            situation.referenceVelocity = new float3(0.5f, 0.1f, -0.2f);
            float3 wanted = course.Next(situation, s_Open, Straight(5f));
            Assert.That(course.Course, Is.EqualTo(1.5f).Within(0.05f));
            Assert.That(math.distance(wanted, situation.referenceVelocity), Is.LessThan(0.45f * 2.5f * k_Step + 1e-5f));
        }

        [Test]
        public void Homing_DrawsTurnsToTheMiddle()
        {
            WanderSettings settings = Straight(0.5f);
            settings.turnSpread = 120f;
            FlightSituation situation = Situation(k_Step);
            situation.position = new float3(4e5f, 0f, 0f);
            float with = Homeward(settings, situation, 1f), without = Homeward(settings, situation, 0f);
            Assert.That(without, Is.Zero.Within(0.1f));
            Assert.That(with, Is.GreaterThan(0.4f));
        }

        private static float Homeward(WanderSettings settings, in FlightSituation situation, float homing)
        {
            settings.homing = homing;
            var course = new ErraticCourse(4);
            float sum = 0f;
            for (int step = 0; step < 20000; step++)
            {
                course.Next(situation, s_Open, settings);
                sum -= math.sin(course.Course) / 20000f;
            }

            return sum;
        }

        private static WanderSettings Straight(float time) => new WanderSettings { speed = 0.8f, straightTime = time, bobTime = 1f };

        private static List<float3> Track(in WanderSettings settings, float seconds, float dt = k_Step)
        {
            FlightSituation situation = Situation(dt);
            var course = new ErraticCourse(11);
            var track = new List<float3>();
            for (int step = 0; step < seconds / dt; step++)
                track.Add(course.Next(situation, s_Open, settings));
            return track;
        }

        // Values that stay for three steps at least, each once.
        private static float[] Plateaus(List<float3> track, System.Func<float3, float> of)
        {
            var found = new List<float>();
            for (int k = 2; k < track.Count; k++)
            {
                bool isFlat = math.distance(track[k], track[k - 1]) < 1e-7f && math.distance(track[k - 1], track[k - 2]) < 1e-7f;
                if (isFlat && (k == 2 || math.distance(track[k - 2], track[math.max(k - 3, 0)]) >= 1e-7f))
                    found.Add(of(track[k]));
            }

            return found.ToArray();
        }

        private static FlightSituation Situation(float dt) => new FlightSituation
        {
            limits = new FlightLimits(1.3f, -0.3f, 0.2f, 2.5f),
            deltaTime = dt,
            unitsPerMetre = 1f,
        };
    }
}
