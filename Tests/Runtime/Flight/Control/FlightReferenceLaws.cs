using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Laws of the reference: filters, bounds, headings, and that no direction and no side is another's.</summary>
    public sealed class FlightReferenceLaws
    {
        private const float k_Step = 0.01f, k_Top = 1.3f, k_Acceleration = 2.5f;

        private TrimTable m_Table;

        [SetUp]
        public void SetUp()
        {
            m_Table = new TrimTable(new[] { 0f, k_Top }, new[] { -0.3f, 0.2f });
            for (int point = 0; point < 4; point++)
                m_Table.Set(point / 2, point % 2, new float[TrimPoint.Floats]);
        }

        [TearDown]
        public void TearDown() => m_Table.Dispose();

        // A small change of a fast insect's speed is followed within a tenth of a second.
        [Test]
        public void ASmallChange_IsFilteredOverATenthOfASecond()
        {
            FlightReference reference = Ahead(1f);
            for (int step = 1; step <= 30; step++)
            {
                reference.Step(new float3(0f, 0f, 1.05f), float.NaN, default, default, m_Table, false, k_Step);
                Assert.That(1.05f - reference.Velocity.z, Is.EqualTo(0.05f * math.pow(0.9f, step)).Within(1e-5f));
            }
        }

        // What the feedback is told is the reference at the start of the step and its rates: carried on with them it meets the next one.
        [Test]
        public void WhatIsFollowedWithinAStep_MeetsTheNextStep([Values(1u, 2u, 3u, 4u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            var reference = new FlightReference(random.NextFloat3(-0.5f, 0.5f), 1f, default);
            for (int step = 0; step < 100; step++)
            {
                float3 wind = random.NextFloat3(-0.1f, 0.1f);
                FlightReference before = reference;
                BodyReference told = reference.Step(new float3(1f, 0.1f, -0.5f), float.NaN, wind, default, m_Table, true, k_Step);
                Assert.That(math.distance(told.velocity, before.Velocity), Is.LessThan(1e-6f));
                Assert.That(told.heading, Is.EqualTo(before.Heading));
                Assert.That(math.distance(told.velocity + told.acceleration * k_Step, reference.Velocity), Is.LessThan(1e-6f));
                Assert.That(told.heading + told.turning * k_Step, Is.EqualTo(reference.Heading).Within(1e-6f));
                math.sincos(reference.Heading, out float sin, out float cos);
                float3 air = reference.Velocity - reference.Wind;
                Assert.That(told.airSpeed, Is.EqualTo(air.x * sin + air.z * cos).Within(1e-6f), "ahead through the air");
                Assert.That(told.climb, Is.EqualTo(air.y).Within(1e-6f), "up through the air");
            }
        }

        [Test]
        public void Wind_IsFilteredOverSevenHundredthsOfASecond([Values(0.005f, 0.02f)] float dt)
        {
            FlightReference reference = Ahead(0f);
            var wind = new float3(0.3f, -0.1f, 0.2f);
            for (float time = dt; time < 0.3f; time += dt)
            {
                reference.Step(default, 0f, wind, default, m_Table, true, dt);
                Assert.That(math.distance(reference.Wind, wind * (1f - math.exp(-time / 0.07f))), Is.LessThan(1e-5f));
            }
        }

        // Ahead a slow insect follows 0.25 of the acceleration, one of 0.45 of its top speed all of it; across its nose it goes with the
        // air.
        [TestCase(0f, 0.25f)]
        [TestCase(0.2925f, 0.625f)]
        [TestCase(0.6f, 1f)]
        [TestCase(1.2f, 1f)]
        public void ASlowInsect_FollowsLess(float speed, float share)
        {
            FlightReference reference = Ahead(speed);
            BodyReference told = reference.Step(new float3(0f, 0f, speed > 1f ? 0f : 9f), 0f, default, default, m_Table, false, 1e-4f);
            Assert.That(math.length(told.acceleration), Is.EqualTo(share * k_Acceleration).Within(0.01f));
            reference = Ahead(0f);
            told = reference.Step(new float3(9f, 0f, 0f), 0.5f * math.PI, new float3(9f, 0f, 0f), default, m_Table, false, 0.05f);
            Assert.That(told.acceleration.x, Is.EqualTo(k_Acceleration).Within(0.01f), "with the air");
        }

        [Test]
        public void NoChange_IsFasterThanTheAcceleration([Values(1u, 2u, 3u, 4u)] uint seed, [Values(0.5f, 2.5f)] float acceleration)
        {
            var random = Random.CreateFromIndex(seed);
            m_Table.Acceleration = acceleration;
            var reference = new FlightReference(default, 0f, default);
            float most = 0f;
            for (int step = 0; step < 300; step++)
            {
                float3 wanted = step % 30 == 0 ? random.NextFloat3(-3f, 3f) : reference.Velocity + 1f;
                most = math.max(most, math.length(reference.Step(wanted, float.NaN, random.NextFloat3(-0.5f, 0.5f), default, m_Table, false,
                    k_Step).acceleration));
            }

            Assert.That(most, Is.EqualTo(acceleration).Within(1e-3f), "all of it is used, and no more");
        }

        // Squares of such speeds are no numbers: the direction counts.
        [Test]
        public void AWantedVelocityBeyondReason_CountsByItsDirection([Values(1e20f, 1e38f)] float size)
        {
            FlightReference reference = Ahead(0.5f), expected = Ahead(0.5f);
            var direction = new float3(0.6f, 0f, 0.8f);
            for (int step = 0; step < 60; step++)
            {
                Step(ref reference, size * direction);
                Step(ref expected, OuterBounds.Speed / 0.8f * direction);
                Assert.That(math.distance(reference.Velocity, expected.Velocity), Is.LessThan(1e-5f));
            }
        }

        // Slower it would hang at a standstill with its nose the wrong way.
        [Test]
        public void OneThatTurnsRound_KeepsUpSomeSpeed_UntilItLooksBack()
        {
            FlightReference reference = Ahead(0.6f);
            var wanted = new float3(0.03f, 0f, -0.15f);
            float least = float.PositiveInfinity;
            for (int step = 0; step < 400; step++)
            {
                reference.Step(wanted, float.NaN, default, default, m_Table, false, k_Step);
                float speed = math.length(reference.Velocity);
                if (math.dot(reference.Velocity, wanted) < -0.3f * speed * math.length(wanted))
                    least = math.min(least, speed);
            }

            Assert.That(least, Is.InRange(0.15f, 0.35f), "half of the cruising speed, with which a slow one turns, or more");

            Assert.That(math.distance(reference.Velocity, wanted), Is.LessThan(0.01f));
        }

        [Test]
        public void ThroughTheAir_NothingFliesFasterThanATenthBeyondItsTable([Values(-0.5f, 0f, 3f)] float wind)
        {
            FlightReference reference = Ahead(0.5f);
            for (int step = 0; step < 500; step++)
                reference.Step(new float3(0f, 0f, 9f), 0f, new float3(0f, 0f, wind), default, m_Table, true, k_Step);
            Assert.That(reference.Velocity.z - wind, Is.EqualTo(1.1f * k_Top).Within(1e-3f), "more wind carries it along");
        }

        [Test]
        public void Climbs_AreThoseOfTheTable_UpAndDown([Values(-9f, 9f)] float wanted, [Values(-0.2f, 0f)] float updraft)
        {
            FlightReference reference = Ahead(0.2f);
            for (int step = 0; step < 500; step++)
                reference.Step(new float3(0f, wanted, 0.2f), 0f, new float3(0f, updraft, 0f), default, m_Table, false, k_Step);
            Assert.That(reference.Velocity.y - updraft, Is.EqualTo(wanted > 0f ? 0.2f : -0.3f).Within(1e-3f));
        }

        // The table closes for fewer climbs where the insect is fast: between two speeds for the share of each.
        [TestCase(0f)]
        [TestCase(0.65f)]
        [TestCase(1.3f)]
        public void AFastInsect_ClimbsAndSinksOnlyAsFarAsItsTableClosesThere(float speed)
        {
            using (var table = new TrimTable(new[] { 0f, k_Top }, new[] { -0.3f, 0f, 0.2f }))
            {
                foreach ((int s, int c) in new[] { (0, 0), (0, 1), (0, 2), (1, 1) })
                    table.Set(s, c, new float[TrimPoint.Floats]);
                table.Fill();
                foreach (float wanted in new[] { -9f, 9f })
                {
                    FlightReference reference = Ahead(speed);
                    for (int step = 0; step < 900; step++)
                        reference.Step(new float3(0f, wanted, speed), 0f, default, default, table, false, k_Step);
                    float share = 1f - speed / k_Top;
                    Assert.That(reference.Velocity.y, Is.InRange(-0.3f * share - 1e-3f, 0.2f * share + 1e-3f));
                }
            }
        }

        // Allowed errors: up to 0.15 m/s none of the error is taken over, beyond it what is more, at 6 per second, along the heading's
        // axes.
        [TestCase(0.1f)]
        [TestCase(0.149f)]
        [TestCase(0.2f)]
        [TestCase(0.7f)]
        public void BeyondTheAllowedError_TheReferenceComesTowardsTheInsect(float size)
        {
            const float heading = 0.5f * math.PI;
            var one = new FlightReference(new float3(1f, 0f, 0f), heading, default);
            FlightReference other = one;
            float3 direction = math.normalize(new float3(1f, -2f, 2f));
            one.Step(new float3(1f, 0f, 0f), float.NaN, default, default, m_Table, true, k_Step);
            other.Step(new float3(1f, 0f, 0f), float.NaN, default, size * direction, m_Table, true, k_Step);
            var turned = new float3(direction.z, direction.y, -direction.x);
            float expected = math.max(size - 0.15f, 0f) * (1f - math.exp(-6f * k_Step));
            Assert.That(math.distance(other.Velocity - one.Velocity, expected * turned), Is.LessThan(1e-6f));
        }

        // Only a cruising insect, from 0.3 m/s on, or a quarter of a slow insect's top speed.
        [TestCase(0.29f, 1.3f, false)]
        [TestCase(0.31f, 1.3f, true)]
        [TestCase(0.09f, 0.4f, false)]
        [TestCase(0.11f, 0.4f, true)]
        public void OnlyOfACruisingInsect_ErrorsAreTakenOver(float speed, float top, bool isTaken)
        {
            using var table = new TrimTable(new[] { 0f, top }, new[] { -0.3f, 0.3f });
            for (int point = 0; point < 4; point++)
                table.Set(point / 2, point % 2, new float[TrimPoint.Floats]);
            FlightReference reference = Ahead(speed);
            reference.Step(new float3(0f, 0f, speed), 0f, default, new float3(0f, 0f, -0.5f), table, true, k_Step);
            Assert.That(reference.Velocity.z < speed - 0.01f, Is.EqualTo(isTaken));
        }

        // A slow insect turns to a wanted heading at 4 per second, filtered, and at most at 3 rad/s, to either side.
        [Test]
        public void ASlowInsect_TurnsToItsWantedHeading([Values(-2.5f, -0.3f, 0.3f, 2.5f)] float wanted)
        {
            FlightReference reference = Ahead(0f);
            float fastest = 0f;
            for (int step = 0; step < 400; step++)
                fastest = math.max(fastest, math.abs(reference.Step(default, wanted, default, default, m_Table, false, k_Step).turning));
            Assert.That(reference.Heading, Is.EqualTo(wanted).Within(0.01f));
            Assert.That(fastest, math.abs(wanted) > 1f ? Is.InRange(2.9f, 3.0001f) : Is.InRange(0.5f, 1.2f));
        }

        [Test]
        public void AHoveringInsect_KeepsItsHeading_AndACreepingOneLooksAlongItsWay([Values(0.1f, 0.2f)] float speed)
        {
            FlightReference reference = Ahead(0f);
            for (int step = 0; step < 400; step++)
                reference.Step(new float3(speed, 0f, 0f), float.NaN, default, default, m_Table, false, k_Step);
            Assert.That(reference.Heading, Is.EqualTo(speed > 0.15f ? 0.5f * math.PI : 0f).Within(0.02f));
        }

        // A fast insect crabs: its nose is along its way through the air, whatever heading is wanted.
        [Test]
        public void AFastInsect_LooksAlongItsWayThroughTheAir([Values(-0.5f, 0.5f)] float side)
        {
            FlightReference reference = Ahead(0.8f);
            for (int step = 0; step < 300; step++)
                reference.Step(new float3(0f, 0f, 0.8f), 2f, new float3(side, 0f, 0f), default, m_Table, true, k_Step);
            Assert.That(reference.Heading, Is.EqualTo(math.atan2(-side, 0.8f)).Within(0.01f));
            Assert.That(math.distance(reference.Velocity, new float3(0f, 0f, 0.8f)), Is.LessThan(0.01f),
                "and its way over ground the wanted one");
        }

        [Test]
        public void IntoAGust_NothingTurnsFasterThanTenRadiansASecond()
        {
            FlightReference reference = Ahead(0.4f);
            float fastest = 0f;
            for (int step = 0; step < 50; step++)
            {
                fastest = math.max(fastest, math.abs(reference.Step(new float3(0f, 0f, 0.4f), 0f, new float3(4f, 0f, 0f), default,
                    m_Table, true, k_Step).turning));
            }

            Assert.That(fastest, Is.EqualTo(10f).Within(1e-3f));
        }

        // From hovering an insect turns first, creeping at half the cruising speed at the most, and sets off 0.6 rad before its way.
        [Test]
        public void AHoveringInsect_TurnsFirst_ThenGoes([Values(-1f, 1f)] float side)
        {
            FlightReference reference = Ahead(0f);
            float alignedAt = 0f;
            for (int step = 0; step < 300 && alignedAt == 0f; step++)
            {
                reference.Step(new float3(side, 0f, 0f), float.NaN, default, default, m_Table, false, k_Step);
                if (math.length(reference.Velocity) > 0.152f)
                    alignedAt = reference.Heading;
            }

            Assert.That(math.abs(side * 0.5f * math.PI - alignedAt), Is.InRange(0.45f, 0.6f));
            for (int step = 0; step < 300; step++)
                reference.Step(new float3(side, 0f, 0f), float.NaN, default, default, m_Table, false, k_Step);
            Assert.That(reference.Velocity.x, Is.EqualTo(side).Within(1e-3f));
        }

        [Test]
        public void WhatIsNoNumber_HoversOnTheSpot()
        {
            FlightReference reference = Ahead(0.2f);
            for (int step = 0; step < 300; step++)
                reference.Step(new float3(0f, float.NaN, 1f), float.NaN, default, default, m_Table, true, k_Step);
            Assert.That(math.length(reference.Velocity), Is.LessThan(1e-4f));
        }

        // A whole flight, turned about the vertical, mirrored, or its reference turned on the way, is the same flight.
        [Test]
        public void ATurnedOrMirroredScene_IsFlownTheSame([Values(1u, 2u, 3u, 4u)] uint seed, [Values(false, true)] bool mirrored)
        {
            var random = Random.CreateFromIndex(seed);
            float by = mirrored ? 0f : 1.1f;
            float3 side = mirrored ? new float3(-1f, 1f, 1f) : 1f;
            var turn = quaternion.AxisAngle(new float3(0f, 1f, 0f), by);
            float3 start = random.NextFloat3(-0.5f, 0.5f);
            var one = new FlightReference(start, 0.4f, default);
            FlightReference other = mirrored ? new FlightReference(side * start, -0.4f, default) : one.Turned(by);
            for (int step = 0; step < 400; step++)
            {
                random = step % 50 == 0 ? Random.CreateFromIndex(seed + (uint)step) : random;
                Random same = random;
                float3 wanted = 1.5f * same.NextFloat3(-1f, 1f), wind = 0.3f * same.NextFloat3(-1f, 1f),
                    error = 0.3f * same.NextFloat3(-1f, 1f);
                float heading = same.NextBool() ? same.NextFloat(-2f, 2f) : float.NaN;
                one.Step(wanted, heading, wind, error, m_Table, true, k_Step);
                other.Step(math.rotate(turn, side * wanted), mirrored ? -heading : heading + by, math.rotate(turn, side * wind),
                    side * error, m_Table, true, k_Step);
                Assert.That(math.distance(math.rotate(turn, side * one.Velocity), other.Velocity), Is.LessThan(2e-3f), $"step {step}");
                Assert.That(Headings.Wrap((mirrored ? -one.Heading : one.Heading + by) - other.Heading), Is.Zero.Within(5e-3f),
                    $"step {step}");
            }
        }

        [Test]
        public void TheSituation_IsThatOfTheBodyAndTheReference()
        {
            var random = Random.CreateFromIndex(7);
            FlyingBody body = default;
            body.position = random.NextFloat3();
            body.rotation = random.NextQuaternionRotation();
            body.velocity = random.NextFloat3();
            body.spin = random.NextFloat3();
            var reference = new FlightReference(random.NextFloat3(), 0.3f, random.NextFloat3());
            FlightSituation situation = reference.Situation(body);
            Assert.That(situation.position, Is.EqualTo(body.position));
            Assert.That(situation.rotation, Is.EqualTo(body.rotation));
            Assert.That(situation.velocity, Is.EqualTo(body.velocity));
            Assert.That(math.distance(situation.angularVelocity, math.rotate(body.rotation, body.spin)), Is.LessThan(1e-6f));
            Assert.That(situation.wind, Is.EqualTo(reference.Wind));
            Assert.That(situation.referenceVelocity, Is.EqualTo(reference.Velocity));
            Assert.That(situation.heading, Is.EqualTo(0.3f));
            Assert.That(situation.unitsPerMetre, Is.EqualTo(1f));
        }

        private static FlightReference Ahead(float speed) => new FlightReference(new float3(0f, 0f, speed), 0f, default);

        private void Step(ref FlightReference reference, float3 wanted) =>
            reference.Step(wanted, float.NaN, default, default, m_Table, true, k_Step);
    }
}
