using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    /// <summary>Reference of the feedback, on its own.</summary>
    public sealed class FlightReferenceTests
    {
        private const float k_Step = 0.01f, k_Top = 1.3f;

        private TrimTable m_Table;

        [SetUp]
        public void SetUp()
        {
            m_Table = new TrimTable(new[] { 0f, k_Top }, new[] { -0.3f, 0.3f });
            for (int point = 0; point < 4; point++)
                m_Table.Set(point / 2, point % 2, new float[TrimPoint.Floats]);
        }

        [TearDown]
        public void TearDown() => m_Table.Dispose();

        // v̇ = a across the way and a turn of the course by a/v: one law for fast insects, and none turns faster than at its top speed.
        [TestCase(0.7f)]
        [TestCase(1f)]
        [TestCase(1.3f)]
        public void ACourse_TurnsNoFasterThanTheLimit(float speed)
        {
            var reference = new FlightReference(new float3(0f, 0f, speed), 0f, default);
            float fastest = 0f, course = 0f;
            for (int step = 0; step < 200; step++)
            {
                reference.Step(new float3(speed, 0f, 0f), float.NaN, default, default, m_Table, true, k_Step);
                float now = math.atan2(reference.Velocity.x, reference.Velocity.z);
                fastest = math.max(fastest, (now - course) / k_Step);
                course = now;
            }

            Assert.That(course, Is.EqualTo(0.5f * math.PI).Within(0.01f), "it gets there");
            Assert.That(fastest, Is.LessThanOrEqualTo(1.05f * m_Table.Limits.TurnRate(speed)));
            Assert.That(fastest, Is.GreaterThan(0.8f * m_Table.Limits.TurnRate(speed)));
        }

        // Pitched or rolled by half a turn a body has the heading that it had; by half a turn about a level axis none, and keeps the last.
        [TestCase(1f, 2.5f, 0f, 1f)]
        [TestCase(-2f, 0f, 2.5f, -2f)]
        [TestCase(1f, math.PI, 0f, 0.5f)]
        public void AnInsectThatTumbles_IsLedFastAheadAlongItsHeading(float heading, float pitch, float roll, float led)
        {
            var wind = new float3(0.2f, 0.1f, 0f);
            var reference = new FlightReference(new float3(0f, 0f, 0.1f), 0.5f, wind);
            var body = new FlyingBody
            {
                rotation = math.mul(quaternion.RotateY(heading), math.mul(quaternion.RotateX(pitch), quaternion.RotateZ(roll))),
                velocity = new float3(0f, -2f, 0f),
                wind = wind,
            };
            BodyReference told = reference.Right(body, m_Table, k_Step);
            Assert.That(reference.Heading, Is.EqualTo(led).Within(1e-4f));
            Assert.That(told.heading, Is.EqualTo(led).Within(1e-4f));
            Assert.That(told.airSpeed, Is.EqualTo(k_Top));
            Assert.That(told.climb, Is.EqualTo(-0.3f));
            var along = new float3(k_Top * math.sin(led), -0.3f, k_Top * math.cos(led));
            Assert.That(math.distance(told.velocity, wind + along), Is.LessThan(1e-4f));
            Assert.That(math.distance(reference.Velocity, told.velocity), Is.Zero);
            Assert.That(math.length(told.acceleration) + math.abs(told.turning), Is.Zero);
        }

        [TestCase(-2f, -0.3f)]
        [TestCase(-0.1f, -0.2f)]
        [TestCase(0.1f, 0f)]
        [TestCase(2f, 0f)]
        public void AnInsectThatTumbles_IsLedDownAsItFalls_AndNeverUp(float rise, float led)
        {
            var wind = new float3(0f, 0.1f, 0f);
            var reference = new FlightReference(default, 0f, wind);
            var body = new FlyingBody { rotation = quaternion.identity, velocity = new float3(0f, rise, 0f), wind = wind };
            Assert.That(reference.Right(body, m_Table, k_Step).climb, Is.EqualTo(led).Within(1e-5f));
        }

        [Test]
        public void OnlyAGuardedInsect_IsLedOutOfATumble([Values] bool isGuarded, [Values] bool rights)
        {
            var body = new FlyingBody { rotation = quaternion.RotateX(2.5f), rights = rights ? 1 : 0 };
            var reference = new FlightReference(new float3(0f, 0f, 0.1f), 0f, default);
            FlightReference twin = reference;
            var command = FlightCommand.Fly(new float3(0f, 0f, 0.2f));
            reference.Lead(ref body, command, m_Table, isGuarded, k_Step);
            BodyReference led = rights
                ? twin.Right(body, m_Table, k_Step)
                : twin.Step(command.velocity, command.heading, default, default, m_Table, isGuarded, k_Step);
            Assert.That(body.recovers, Is.EqualTo(isGuarded ? 1 : 0));
            Assert.That(math.distance(body.reference.velocity, led.velocity) + math.abs(body.reference.airSpeed - led.airSpeed), Is.Zero);
        }

        [Test]
        public void TurnRadius_IsSpeedOverTurnRate()
        {
            var limits = new FlightLimits(1.25f, -0.3f, 0.3f, 2.5f);
            Assert.That(limits.TurnRate(0f), Is.EqualTo(2f));
            Assert.That(limits.TurnRate(1.25f), Is.EqualTo(2f));
            Assert.That(limits.TurnRate(-2.5f), Is.EqualTo(1f));
            Assert.That(limits.TurnRadius(0.5f), Is.EqualTo(0.25f));
            Assert.That(limits.TurnRadius(2.5f), Is.EqualTo(2.5f));
        }

        [TestCase(0f, 5f)]
        [TestCase(1f, 0.7f)]
        public void AClimb_ChangesSlowlyOnlyWhereTheInsectCruises(float speed, float fastest)
        {
            var reference = new FlightReference(new float3(0f, 0f, speed), 0f, default);
            float most = 0f, before = 0f;
            for (int step = 0; step < 200; step++)
            {
                reference.Step(new float3(0f, 9f, speed), 0f, default, default, m_Table, false, k_Step);
                most = math.max(most, (reference.Velocity.y - before) / k_Step);
                before = reference.Velocity.y;
            }

            Assert.That(before, Is.EqualTo(0.3f).Within(1e-3f), "the table's fastest climb");
            Assert.That(most, Is.LessThan(1.01f * fastest));
            Assert.That(most, Is.GreaterThan(0.1f * fastest));
        }

        // The stream's change is met at once: a filter of 0.07 s, not 0.7 m/s².
        [Test]
        public void AnUpdraft_DoesNotChangeTheWantedClimb()
        {
            var reference = new FlightReference(new float3(0f, 0f, 1f), 0f, default);
            for (int step = 0; step < 100; step++)
                reference.Step(new float3(0f, 0f, 1f), 0f, new float3(0f, 0.2f, 0f), default, m_Table, true, k_Step);
            Assert.That(reference.Velocity.y, Is.Zero.Within(1e-4f));
        }

        [Test]
        public void AnInsectThatHasLostItsSpeed_IsWaitedFor()
        {
            var error = new float3(0f, -0.1f, -0.6f);
            var reference = new FlightReference(new float3(1f, 0f, 0f), 0.5f * math.PI, default);
            for (int step = 0; step < 30; step++)
                reference.Step(new float3(1f, 0f, 0f), float.NaN, default, error, m_Table, false, k_Step);
            Assert.That(reference.Velocity.x, Is.InRange(0.3f, 0.8f));
            for (int step = 0; step < 200; step++)
                reference.Step(new float3(1f, 0f, 0f), float.NaN, default, default, m_Table, false, k_Step);
            Assert.That(reference.Velocity.x, Is.EqualTo(1f).Within(1e-3f), "and gets its speed back");
        }

        // The less the more it is off, at 0.2 m/s and beyond a twentieth; a command that is not guarded waits for nobody. The rate sets in
        // over 0.03 s.
        [Test]
        public void AnInsectThatHasNotFollowed_IsNotToldToGoOn([Values(0f, 0.05f, 0.15f, 0.5f)] float off,
            [Values(false, true)] bool guarded)
        {
            var wanted = new float3(0f, 0f, 0.4f);
            BodyReference told = FirstOf(wanted, 0f, off, guarded), all = FirstOf(wanted, 0f, 0f, false);
            Assert.That(all.acceleration.z, Is.GreaterThan(0.1f));
            float setsIn = guarded ? 1f - math.exp(-k_Step / 0.03f) : 1f;
            Assert.That(told.acceleration.z / all.acceleration.z, Is.EqualTo(setsIn * Share(off, guarded)).Within(1e-4f));
        }

        [Test]
        public void ASlowInsectThatHasNotFollowed_IsNotTurnedOn([Values(0f, 0.05f, 0.15f, 0.5f)] float off,
            [Values(false, true)] bool guarded)
        {
            BodyReference told = FirstOf(default, 0.25f, off, guarded), all = FirstOf(default, 0.25f, 0f, false);
            Assert.That(all.turning, Is.GreaterThan(0.05f));
            Assert.That(told.turning / all.turning, Is.EqualTo(Share(off, guarded)).Within(1e-4f));
        }

        private static float Share(float off, bool guarded) => guarded ? math.max(1f - off / 0.2f, 0.05f) : 1f;

        private BodyReference FirstOf(float3 wanted, float heading, float off, bool guarded) =>
            new FlightReference(new float3(0f, 0f, wanted.z * 0.5f), 0f, default)
                .Step(wanted, heading, default, off * new float3(0.6f, 0f, -0.8f), m_Table, guarded, k_Step);

        [TestCase(1f, 0.15f)]
        [TestCase(0.2f, 0.6f)]
        public void SmallErrors_AndThoseOfASlowInsect_ChangeNothing(float speed, float error)
        {
            var one = new FlightReference(new float3(0f, 0f, speed), 0f, default);
            FlightReference other = one;
            for (int step = 0; step < 100; step++)
            {
                one.Step(new float3(0f, 0f, speed), 0f, default, default, m_Table, true, k_Step);
                other.Step(new float3(0f, 0f, speed), 0f, default, new float3(0f, 0f, -error), m_Table, true, k_Step);
            }

            Assert.That(other.Velocity, Is.EqualTo(one.Velocity));
        }
    }
}
