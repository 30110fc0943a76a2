using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Landing, sitting and taking off, flown by a point.</summary>
    public sealed class LandingTests
    {
        private const float k_Stand = 6e-3f;

        [Test]
        public void Points_ComeDownSlowly_OnRandomSlopes([NUnit.Framework.Range(1, 40)] int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            PerchSpot spot = RandomSpot(ref random);
            var flyer = new PointFlyer();
            var way = new float3(random.NextFloat(-20f, 20f), random.NextFloat(5f, 20f), random.NextFloat(-20f, 20f));
            flyer.situation.position = spot.position
                + (math.dot(way, spot.normal) > 0f ? way : way - 2f * math.dot(way, spot.normal) * spot.normal) + 2f * spot.normal;
            flyer.situation.referenceVelocity = flyer.situation.velocity = new float3(
                random.NextFloat(-1f, 1f), 0f, random.NextFloat(-1f, 1f));
            var landing = new Landing(spot, k_Stand);
            for (int step = 0; step < 40 * 50; step++)
            {
                FlightCommand command = landing.Next(flyer.situation);
                if (command.wish == FlightWish.Perch)
                {
                    float3 off = (flyer.situation.position - spot.position) / 10f;
                    Assert.That(math.length(flyer.situation.velocity), Is.LessThan(0.3f));
                    float height = k_Stand + Landing.Clearance * flyer.situation.wingLength;
                    Assert.That(math.length(off - height * spot.normal), Is.LessThan(0.4f * flyer.situation.wingLength),
                        "where the wings clear the spot");
                    return;
                }

                Assert.That(command.wish, Is.EqualTo(FlightWish.Land));
                Assert.That(math.dot(flyer.situation.position - spot.position, spot.normal), Is.GreaterThan(-0.05f),
                    "the body stays above the surface");
                flyer.Fly(command);
            }

            Assert.Fail($"not down after 40 s, at {(flyer.situation.position - spot.position) / 10f} m, {landing.Attempts} attempts");
        }

        [Test]
        public void APointAboveTheLine_SinksToIt_AndFliesOnAhead([Values(0.02f, 0.05f, 0.08f)] float above)
        {
            var spot = new PerchSpot { position = new float3(1f, 2f, 3f), normal = new float3(0f, 1f, 0f), heading = 0f };
            var landing = new Landing(spot, k_Stand);
            var flyer = new PointFlyer();
            float height = k_Stand + Landing.Clearance * flyer.situation.wingLength;
            flyer.situation.position = spot.position + 10f * new float3(0f, height + 0.45f * 0.5f + above, -0.5f);
            flyer.situation.velocity = flyer.situation.referenceVelocity = new float3(0f, 0f, 0.12f);
            FlightCommand command = landing.Next(flyer.situation);
            for (int step = 0; step < 20; step++)
            {
                command = landing.Next(flyer.situation);
                Assert.That(landing.IsFlaring);
                Assert.That(command.velocity.z, Is.GreaterThan(0.099f), "m/s ahead");
            }

            Assert.That(command.velocity.y, Is.LessThan(-0.06f), "steeper than the line");
        }

        // Its raised wings would meet the ceiling before it is as near as one that comes slowly may get. Within its reach, and over a
        // floor, it may come nearer.
        [TestCase(-1f, 1.2f, 0.3f, FlightWish.Perch)]
        [TestCase(-1f, 1.2f, 0f, FlightWish.Land)]
        [TestCase(-1f, 0.5f, 0.3f, FlightWish.Land)]
        [TestCase(1f, 1.2f, 0.3f, FlightWish.Land)]
        public void BelowACeiling_WhoeverRisesFastBesideItsReach_IsHeldBeforeItIsTooNear(
            float up, float aside, float nearing, FlightWish wish)
        {
            var spot = new PerchSpot { position = new float3(1f, 2f, 3f), normal = new float3(0f, up, 0f), heading = 0f };
            var landing = new Landing(spot, k_Stand);
            var flyer = new PointFlyer();
            float reach = 0.4f * flyer.situation.wingLength, height = k_Stand + Landing.Clearance * flyer.situation.wingLength;
            float3 seat = spot.position + 10f * height * spot.normal;
            flyer.situation.position = seat + 10f * new float3(0f, up > 0f ? 0.45f * 0.5f : -0.15f * 0.4f, up > 0f ? -0.5f : -0.4f);
            flyer.situation.velocity = flyer.situation.referenceVelocity = new float3(0f, 0f, 0.12f);
            landing.Next(flyer.situation);
            Assert.That(landing.IsFlaring);
            flyer.situation.position = seat + 10f * reach * new float3(aside, -0.2f * up, 0f);
            flyer.situation.velocity = flyer.situation.referenceVelocity = new float3(0f, -nearing * up, 0.05f);
            Assert.That(landing.Next(flyer.situation).wish, Is.EqualTo(wish));
        }

        // Six seconds more than the line takes at half of its speed, 0.12 m/s, without coming nearer.
        [Test]
        public void WhoeverHangsOnTheLine_GoesRound()
        {
            var spot = new PerchSpot { position = new float3(1f, 2f, 3f), normal = new float3(0f, 1f, 0f), heading = 0f };
            var landing = new Landing(spot, k_Stand);
            var flyer = new PointFlyer();
            float height = k_Stand + Landing.Clearance * flyer.situation.wingLength;
            var off = new float3(0f, 0.45f * 0.5f + 0.05f, -0.5f);
            flyer.situation.position = spot.position + 10f * (off + height * spot.normal);
            flyer.situation.velocity = flyer.situation.referenceVelocity = new float3(0f, 0f, 0.12f);
            float along = math.dot(off, math.normalize(new float3(0f, 0.45f, -1f))), time = 0f;
            landing.Next(flyer.situation);
            Assert.That(landing.IsFlaring);
            while (landing.Attempts == 0 && time < 40f)
            {
                landing.Next(flyer.situation);
                time += flyer.situation.deltaTime;
            }

            Assert.That(time, Is.EqualTo(6f + along / 0.06f).Within(0.05f));
            Assert.That(landing.IsFlaring, Is.False);
        }

        [Test]
        public void AnInsect_LandsSitsAndLeaves_WhenItsTimeIsUp()
        {
            PerchSettings settings = PerchSettings.Default;
            settings.flightTime = settings.stayTime = 2f;
            var plan = new PerchPlan(3);
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 20f, -10f);
            float sat = 0f;
            int landings = 0;
            PerchStage last = PerchStage.Between;
            for (int step = 0; step < 150 * 50; step++)
            {
                if (plan.WantsSpot)
                    plan.Land(new PerchSpot { position = new float3(0f, 5f, 0f), normal = new float3(0f, 1f, 0f) }, k_Stand);
                flyer.Fly(plan.Next(flyer.situation, settings, float.NaN, FlightCommand.Fly(new float3(0f, 0f, 0.2f))));
                sat += plan.Stage == PerchStage.Perched ? 0.02f : 0f;
                landings += plan.Stage == PerchStage.Perched && last != PerchStage.Perched ? 1 : 0;
                if (last == PerchStage.TakingOff && plan.Stage == PerchStage.Between)
                    Assert.That(flyer.situation.position.y, Is.GreaterThan(5.5f), "forward and up");
                last = plan.Stage;
            }

            Assert.That(landings, Is.GreaterThan(6));
            Assert.That(sat / landings, Is.InRange(1f, 3f));
        }

        [Test]
        public void AnInsectThatSits_FleesFromWhatComesNear()
        {
            PerchSettings settings = PerchSettings.Default;
            settings.flightTime = 0f;
            settings.stayTime = 600f;
            var plan = new PerchPlan(1);
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 9f, 0f);
            plan.Land(new PerchSpot { position = new float3(0f, 5f, 0f), normal = new float3(0f, 1f, 0f) }, k_Stand);
            for (int step = 0; step < 30 * 50 && plan.Stage != PerchStage.Perched; step++)
                flyer.Fly(plan.Next(flyer.situation, settings, float.NaN, default));
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Perched));
            var threat = new float3(0f, 5f, 3f);
            for (int step = 0; step < 60; step++)
                flyer.Fly(plan.Next(flyer.situation, settings, threat, default));
            Assert.That(plan.Stage, Is.EqualTo(PerchStage.Between));
            Assert.That(math.distance(flyer.situation.position, threat), Is.GreaterThan(3f));
            Assert.That(plan.WantsSpot, Is.False, "not while the threat is near");
        }

        [Test]
        public void Wings_FoldFirst_ThenOpenAndCloseSlowly()
        {
            PerchSettings settings = PerchSettings.Default;
            var rest = new WingRest();
            float before = 0f, least = 1f;
            for (int step = 0; step < 500; step++)
            {
                rest.Step(0.02f, true, settings);
                Assert.That(math.abs(rest.Fold - before), Is.LessThan(0.02f / settings.foldTime + 1e-5f));
                before = rest.Fold;
                if (step == 25)
                    Assert.That(rest.Fold, Is.EqualTo(1f).Within(1e-3f));
                least = step > 25 ? math.min(least, rest.Fold) : least;
            }

            Assert.That(least, Is.EqualTo(1f - settings.bask).Within(0.02f));
            rest.Step(0.02f, false, settings);
            Assert.That(rest.Fold, Is.Zero);
        }

        [Test]
        public void OneThatHasComeTooLow_FliesRoundAheadAndUp_AwayFromTheSlope_ForAWhile()
        {
            float slope = math.radians(40f);
            var spot = new PerchSpot { normal = new float3(math.sin(slope), math.cos(slope), 0f), heading = 0f };
            var landing = new Landing(spot, k_Stand);
            var flyer = new PointFlyer();
            // Behind the surface of the seat by 5 cm, heading along the slope.
            float height = k_Stand + Landing.Clearance * flyer.situation.wingLength;
            flyer.situation.position = 10f * (height - 0.05f) * spot.normal;
            flyer.situation.velocity = flyer.situation.referenceVelocity = new float3(0f, 0f, 0.6f);
            FlightCommand command = landing.Next(flyer.situation);

            Assert.That((landing.Attempts, landing.IsFlaring), Is.EqualTo((1, false)));
            Assert.That(command.velocity.x, Is.GreaterThan(0.05f), "down the slope");
            Assert.That(command.velocity.z, Is.GreaterThan(0.2f), "ahead");
            Assert.That(command.velocity.y, Is.GreaterThan(0.6f * flyer.situation.limits.MostClimb));
            int steps = 0;
            for (; steps < 200 && landing.Attempts == 1 && Climbs(landing.Next(flyer.situation)); steps++)
                continue;
            Assert.That(steps * flyer.situation.deltaTime, Is.EqualTo(1.6f).Within(0.05f), "on the spot until its time is over");

            // On its way it is over as soon as it is far enough.
            var other = new Landing(spot, k_Stand);
            other.Next(flyer.situation);
            Assert.That(Climbs(other.Next(flyer.situation)), Is.True);
            flyer.situation.position = 10f * (height * spot.normal + new float3(0f, 0.3f, 0.7f));
            Assert.That(Climbs(other.Next(flyer.situation)), Is.False);

            bool Climbs(FlightCommand now) => now.velocity.y > 0.6f * flyer.situation.limits.MostClimb;
        }

        [Test]
        public void ACourseIntoTheSlope_IsTurnedToItsSide_ByWhichTheInsectComes([Values(-0.8f, -0.3f, 0.3f, 0.8f)] float aside)
        {
            // Down a slope of 40° lies x; the line rises by 0.45 of its length, and keeps 0.3 of that from the surface.
            float slope = math.radians(40f), most = (0.45f * math.cos(slope) - 0.3f) / math.sin(slope);
            var spot = new PerchSpot { normal = new float3(math.sin(slope), math.cos(slope), 0f), heading = float.NaN };
            float3 course = math.normalize(new float3(1f, 0f, aside));
            var flyer = new PointFlyer();
            flyer.situation.position = -30f * course + new float3(0f, 30f, 0f);
            flyer.situation.velocity = flyer.situation.referenceVelocity = 0.6f * course;
            flyer.situation.heading = math.atan2(course.x, course.z);
            FlightCommand command = new Landing(spot, k_Stand).Next(flyer.situation);

            var turned = new float2(math.sin(command.heading), math.cos(command.heading));
            Assert.That(turned.x, Is.EqualTo(most).Within(0.01f), "as far down as there is room beside the slope");
            Assert.That(math.sign(turned.y), Is.EqualTo(math.sign(aside)));
        }

        [Test]
        public void ASpotWithoutAHeading_GetsThatOfTheInsect_AndOneWithIt_KeepsIt([Values(float.NaN, 0.3f)] float wanted)
        {
            var spot = new PerchSpot { normal = new float3(0f, 1f, 0f), heading = wanted };
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(2f, 3f, -9f);
            flyer.situation.heading = -1.1f;
            var landing = new Landing(spot, k_Stand);
            FlightCommand command = landing.Next(flyer.situation);
            for (int step = 0; step < 2000 && command.wish != FlightWish.Perch; step++)
            {
                flyer.Fly(command);
                command = landing.Next(flyer.situation);
            }

            Assert.That(command.wish, Is.EqualTo(FlightWish.Perch));
            Assert.That(command.spot.heading, Is.EqualTo(float.IsNaN(wanted) ? flyer.situation.heading : wanted));
            Assert.That(landing.Spot.heading, Is.EqualTo(command.spot.heading));
        }

        [Test]
        public void FromFarAway_ItComesAtSeventyHundredthsOfItsTopSpeed()
        {
            var spot = new PerchSpot { normal = new float3(0f, 1f, 0f), heading = 0f };
            var flyer = new PointFlyer();
            flyer.situation.position = new float3(0f, 20f, -300f);
            var landing = new Landing(spot, k_Stand);
            for (int step = 0; step < 400; step++)
                flyer.Fly(landing.Next(flyer.situation));

            Assert.That(math.length(flyer.situation.velocity), Is.EqualTo(0.7f * flyer.situation.limits.TopSpeed).Within(3).Percent);
        }

        private static PerchSpot RandomSpot(ref Random random)
        {
            float slope = math.radians(random.NextFloat(0f, 45f)), way = random.NextFloat(0f, 2f * math.PI);
            return new PerchSpot
            {
                position = random.NextFloat3(-50f, 50f),
                normal = new float3(math.sin(slope) * math.sin(way), math.cos(slope), math.sin(slope) * math.cos(way)),
                heading = random.NextFloat(-math.PI, math.PI),
            };
        }
    }
}
