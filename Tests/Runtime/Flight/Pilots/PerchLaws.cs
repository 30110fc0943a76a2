using System.Collections.Generic;
using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Times of flights and stays, ways of taking off, folding of wings, and what is learned on the line down.</summary>
    public sealed class PerchLaws
    {
        private const float k_Stand = 6e-3f, k_Length = 0.06f;

        // Half to one and a half times as long, all alike; the first one too.
        [Test]
        public void Flights_LastAboutTheirTime()
        {
            var times = new List<float>();
            for (int seed = 1; seed <= 300; seed++)
            {
                var plan = new PerchPlan(seed);
                PerchSettings settings = PerchSettings.Default;
                settings.flightTime = 4f;
                float time = 0f;
                while (!plan.WantsSpot)
                {
                    Assert.That(plan.Next(Situation(), settings, float.NaN, FlightCommand.Fly(1f)).velocity, Is.EqualTo(new float3(1f)));
                    time += 0.02f;
                }

                plan.Next(Situation(), settings, 3f, default);
                Assert.That(plan.WantsSpot, Is.False, "not while something is near");
                times.Add(time);
            }

            Check(times, 4f);
        }

        // Level and away, at least as fast as it takes off; it rises and sinks as it would without.
        [TestCase(0f, 1.3f)]
        [TestCase(0.2f, 1.3f)]
        [TestCase(1.5f, 1.3f)]
        [TestCase(0.1f, 0.4f)]
        public void InFlight_AThreatIsFledFrom(float speed, float top)
        {
            FlightSituation situation = Situation();
            situation.limits = new FlightLimits(top, -0.3f, 0.3f, 2.5f);
            var between = FlightCommand.Fly(new float3(speed, 0.3f, 0f));
            float3 threat = situation.position + new float3(2f, 1f, -2f);
            float3 fled = new PerchPlan(1).Next(situation, PerchSettings.Default, threat, between).velocity;

            float wanted = math.max(speed, math.min(0.65f, situation.limits.TopSpeed));
            Assert.That(fled.y, Is.EqualTo(0.3f));
            Assert.That(math.length(fled.xz), Is.EqualTo(wanted).Within(1e-5f));
            Assert.That(math.dot(fled.xz, math.normalize(new float2(-1f, 1f))), Is.EqualTo(wanted).Within(1e-5f));
        }

        [Test]
        public void Stays_LastAboutTheirTime_FromWhenTheFeetAreDown()
        {
            var times = new List<float>();
            for (int seed = 1; seed <= 300; seed++)
            {
                var plan = new PerchPlan(seed);
                PerchSettings settings = PerchSettings.Default;
                settings.stayTime = 4f;
                FlightSituation situation = Sitting(plan, settings);
                situation.state = FlightState.Landing;
                for (int step = 0; step < 400; step++)
                    plan.Next(situation, settings, float.NaN, default);
                Assert.That(plan.Stage, Is.EqualTo(PerchStage.Perched), "on its last way down it does not sit yet");
                situation.state = FlightState.Perched;
                float time = 0f;
                while (plan.Stage == PerchStage.Perched)
                {
                    plan.Next(situation, settings, float.NaN, default);
                    time += 0.02f;
                }

                times.Add(time);
            }

            Check(times, 4f);
        }

        // A time that is changed while it runs counts from where it began.
        [TestCase(100f, 2f)]
        [TestCase(2f, 100f)]
        public void Times_ThatChangeMeanwhile_Count(float before, float after)
        {
            var plan = new PerchPlan(3);
            PerchSettings settings = PerchSettings.Default;
            settings.flightTime = settings.stayTime = before;
            for (int step = 0; step < 40; step++)
                plan.Next(Situation(), settings, float.NaN, default);
            Assert.That(plan.WantsSpot, Is.False);
            settings.flightTime = settings.stayTime = after;
            for (int step = 0; step < 120; step++)
                plan.Next(Situation(), settings, float.NaN, default);
            Assert.That(plan.WantsSpot, Is.EqualTo(after < 10f));

            settings.stayTime = before;
            FlightSituation situation = Sitting(plan, settings);
            situation.state = FlightState.Perched;
            for (int step = 0; step < 40; step++)
                plan.Next(situation, settings, float.NaN, default);
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Perched));
            settings.stayTime = after;
            int left = 0;
            for (int step = 0; step < 120; step++)
            {
                plan.Next(situation, settings, float.NaN, default);
                left += plan.Stage == PerchStage.Perched ? 0 : 1;
            }

            Assert.That(left > 0, Is.EqualTo(after < 10f));
        }

        // What has been fanned stays: a rate that doubles in the fold's second half is no jump.
        [Test]
        public void ARateThatChanges_MovesNoWingAtOnce()
        {
            PerchSettings settings = PerchSettings.Default;
            var rest = new WingRest();
            for (int step = 0; step < 3000; step++)
                rest.Step(0.02f, true, settings);
            float fold = rest.Fold;
            settings.fanRate *= 1.02f;
            for (int step = 0; step < 10; step++)
                rest.Step(0.02f, true, settings);
            float most = 0.2f * settings.bask * math.PI * settings.fanRate / 60f;
            Assert.That(math.abs(rest.Fold - fold), Is.LessThan(1.01f * most));
        }

        // Ahead, and as far again by 0.7 away from what comes near; along a slope and down it, never into it.
        [TestCase(0f, float.NaN, 0f)]
        [TestCase(0f, 90f, -35f)]
        [TestCase(30f, float.NaN, 0f)]
        public void ItTakesOff_AheadAndAway(float slope, float threatFrom, float degrees)
        {
            var plan = new PerchPlan(1);
            FlightSituation situation = Situation();
            situation.state = FlightState.Perched;
            situation.heading = 0.5f;
            float away = 0.5f + math.radians(degrees);
            situation.referenceVelocity = 0.7f * Along(away);
            plan.Sit(new PerchSpot
            {
                position = situation.position,
                normal = new float3(0f, math.cos(math.radians(slope)), 0f) + math.sin(math.radians(slope)) * Along(0.5f)
            });
            plan.TakeOff();
            float3 threat = float.IsNaN(threatFrom) ? float.NaN : situation.position + 2f * Along(0.5f + math.radians(threatFrom));
            float3 velocity = plan.Next(situation, PerchSettings.Default, threat, default).velocity;
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.TakingOff));
            Assert.That(velocity.y, Is.EqualTo(0.3f).Within(1e-5f), "its fastest climb");
            Assert.That(math.length(velocity.xz), Is.EqualTo(0.65f).Within(1e-4f));
            Assert.That(math.degrees(Headings.Wrap(math.atan2(velocity.x, velocity.z) - away)), Is.Zero.Within(0.1f));
        }

        [Test]
        public void BeforeASlope_ItTakesOffDownIt()
        {
            var plan = new PerchPlan(1);
            FlightSituation situation = Situation();
            situation.heading = 0f;
            situation.referenceVelocity = 0.7f * Along(0.5f * math.PI + 0.5f);
            plan.Sit(new PerchSpot { position = situation.position, normal = math.normalize(new float3(0.2f, 1f, -0.7f)) });
            plan.TakeOff();
            float3 velocity = plan.Next(situation, PerchSettings.Default, float.NaN, default).velocity;
            Assert.That(math.dot(velocity.xz, new float2(0.2f, -0.7f)), Is.GreaterThan(0f));
            Assert.That(velocity.x, Is.GreaterThan(0f), "to the side that it looks to");
        }

        // Straight into a slope there is no way along it to go on with: it goes aside.
        [Test]
        public void StraightBeforeASlope_ItTakesOffAcrossIt()
        {
            const float slope = 0.5f;
            var plan = new PerchPlan(1);
            FlightSituation situation = Situation();
            situation.heading = 0f;
            float down = 1.2f * math.sin(slope), course = math.atan2(-1f, -down);
            situation.referenceVelocity = 0.7f * Along(course);
            plan.Sit(new PerchSpot { position = situation.position, normal = new float3(0f, math.cos(slope), -math.sin(slope)) });
            plan.TakeOff();
            float3 velocity = plan.Next(situation, PerchSettings.Default, float.NaN, default).velocity;
            Assert.That(Headings.Wrap(math.atan2(velocity.x, velocity.z) - course), Is.Zero.Within(1e-3f));
        }

        [TestCase(0.49f, false)]
        [TestCase(0.51f, true)]
        public void HalfAMetreAway_ItHasTakenOff(float way, bool isOff)
        {
            var plan = new PerchPlan(1);
            FlightSituation situation = Situation();
            situation.unitsPerMetre = 10f;
            plan.Sit(new PerchSpot { position = situation.position, normal = new float3(0f, 1f, 0f) });
            plan.TakeOff();
            plan.Next(situation, PerchSettings.Default, float.NaN, default);
            situation.position += 10f * way * Along(1f);
            plan.Next(situation, PerchSettings.Default, float.NaN, default);
            Assert.That(plan.Stage, Is.EqualTo(isOff ? PerchStage.Between : PerchStage.TakingOff));
        }

        [Test]
        public void TakingOff_LastsTwoAndAHalfSecondsAtMost()
        {
            var plan = new PerchPlan(1);
            FlightSituation situation = Situation();
            plan.Sit(new PerchSpot { position = situation.position, normal = new float3(0f, 1f, 0f) });
            plan.TakeOff();
            int steps = 0;
            do
            {
                plan.Next(situation, PerchSettings.Default, float.NaN, default);
                steps++;
            }
            while (plan.Stage == PerchStage.TakingOff);
            Assert.That(steps * situation.deltaTime, Is.EqualTo(2.5f).Within(0.03f));
        }

        [Test]
        public void OneThatIsTakenOffOnItsWay_FliesOn()
        {
            var plan = new PerchPlan(1);
            plan.Land(new PerchSpot { normal = new float3(0f, 1f, 0f) }, k_Stand);
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Approaching));
            plan.TakeOff();
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Between));
            Assert.That(plan.WantsSpot, Is.False);
            plan.Land(new PerchSpot { normal = new float3(0f, 1f, 0f) }, k_Stand);
            var between = FlightCommand.Fly(new float3(1f, 2f, 3f));
            Assert.That(plan.Next(Situation(), PerchSettings.Default, 1f, between).velocity, Is.EqualTo(between.velocity),
                "so does one that something comes near");
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Between));
        }

        // Closed within its time, then 1 − bask · (½ − ½ cos) of so many openings a minute.
        [Test]
        public void Wings_FanByTheirRate([Values(0.3f, 0.8f)] float bask, [Values(6f, 20f)] float rate)
        {
            PerchSettings settings = PerchSettings.Default;
            settings.bask = bask;
            settings.fanRate = rate;
            settings.foldTime = 1f;
            var rest = new WingRest();
            for (int step = 1; step <= 1000; step++)
            {
                rest.Step(0.01f, true, settings);
                float time = step * 0.01f, opened = 0.5f - 0.5f * math.cos(2f * math.PI * (time - 1f) * rate / 60f);
                Assert.That(rest.Fold, Is.EqualTo(time < 1f ? time : 1f - bask * opened).Within(2e-3f), $"{time} s");
            }
        }

        [TestCase(0f, 12f, 1f)]
        [TestCase(0.7f, 0f, 0.3f)]
        public void WithoutARate_WingsStayOpen_WithoutBasking_Closed(float bask, float rate, float fold)
        {
            PerchSettings settings = PerchSettings.Default;
            settings.bask = bask;
            settings.fanRate = rate;
            var rest = new WingRest();
            for (int step = 0; step < 300; step++)
                rest.Step(0.01f, true, settings);
            Assert.That(rest.Fold, Is.EqualTo(fold).Within(1e-4f));
            rest.Step(0.01f, false, settings);
            Assert.That(rest.Fold, Is.Zero);
            rest.Step(0.01f, true, settings);
            Assert.That(rest.Fold, Is.EqualTo(0.01f / settings.foldTime).Within(1e-5f), "it begins again");
        }

        // An insect that stays 1.4 cm beside its line is steered back at 2 per second of it, and by a drift that grows by 1 per second
        // of it, up to 0.05 m/s; one that
        // is 1.6 cm off learns none.
        [Test]
        public void ADriftOffTheLine_IsLearned_UpToItsBound([Values(-0.014f, 0.014f, 0.016f)] float beside)
        {
            var landing = new Landing(new PerchSpot { normal = new float3(0f, 1f, 0f), heading = float.NaN }, k_Stand);
            FlightSituation situation = Situation();
            float3 line = math.normalize(new float3(0f, 0.45f, -1f)), seat = new float3(0f, k_Stand + 1.2f * k_Length, 0f);
            situation.position = seat + 0.4f * line;
            situation.velocity = situation.referenceVelocity = new float3(0f, -0.04f, 0.1f);
            landing.Next(situation);
            Assert.That(landing.IsFlaring);
            situation.position.x = beside;
            for (int step = 1; step <= 500; step++)
            {
                float aside = landing.Next(situation).velocity.x;
                float drift = math.abs(beside) < 0.015f ? math.clamp(step * 0.02f * beside, -0.05f, 0.05f) : 0f;
                Assert.That(aside, Is.EqualTo(-2f * beside - drift).Within(1e-4f), $"step {step}");
            }
        }

        private static FlightSituation Sitting(PerchPlan plan, in PerchSettings settings)
        {
            FlightSituation situation = Situation();
            plan.Land(new PerchSpot { normal = new float3(0f, 1f, 0f), heading = 0f }, k_Stand);
            var seat = new float3(0f, k_Stand + 1.2f * k_Length, 0f);
            situation.position = seat + 0.4f * math.normalize(new float3(0f, 0.45f, -1f));
            for (int step = 0; step < 5 && plan.Stage != PerchStage.Perched; step++)
            {
                plan.Next(situation, settings, float.NaN, default);
                situation.position = seat;
            }

            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Perched));
            return situation;
        }

        private static void Check(List<float> times, float mean)
        {
            float sum = 0f, least = float.MaxValue, most = 0f;
            foreach (float time in times)
            {
                sum += time / times.Count;
                least = math.min(least, time);
                most = math.max(most, time);
            }

            Assert.That(sum, Is.EqualTo(mean).Within(0.07f * mean));
            Assert.That(least, Is.InRange(0.49f * mean, 0.55f * mean));
            Assert.That(most, Is.InRange(1.45f * mean, 1.51f * mean));
        }

        private static FlightSituation Situation() => new FlightSituation
        {
            position = new float3(1f, 2f, 3f),
            rotation = quaternion.identity,
            limits = new FlightLimits(1.3f, -0.3f, 0.3f, 2.5f),
            deltaTime = 0.02f,
            wingLength = k_Length,
            unitsPerMetre = 1f,
        };

        private static float3 Along(float course) => new float3(math.sin(course), 0f, math.cos(course));
    }
}
