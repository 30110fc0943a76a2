using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Flight
{
    /// <summary>Commands within the limits of an insect, branch by branch.</summary>
    public sealed class CommandGuardLaws
    {
        [Test]
        public void AFastInsect_IsLedRoundAnArc_OrBrakes([Values(-1.7f, -1.5f, -1.1f, -0.9f, 0.9f, 1.1f, 1.5f, 1.7f)] float off,
            [Values(0.4f, 1.2f)] float speed)
        {
            const float course = 0.7f, flown = 0.8f;
            FlightCommand limited = Limit(FlightCommand.Fly(speed * Along(course + off)), Situation(flown * Along(course), 2f));
            float3 expected = speed * Along(course + off);
            if (math.abs(off) > 1.6f)
                expected = default;
            else if (math.abs(off) > 1f)
                expected = math.min(speed, flown) * Along(course + math.sign(off));
            Assert.That(math.distance(limited.velocity, expected), Is.LessThan(1e-5f));
            Assert.That(limited.heading, Is.NaN, "where it looks is left to the flight");
        }

        [TestCase(0.15f, 0f, 0.12f, 0f)]
        [TestCase(-0.15f, 0f, -0.12f, 0f)]
        [TestCase(0.05f, 0.1f, 0.05f, 0.1f)]
        [TestCase(0f, -0.15f, 0f, -0.06f)]
        [TestCase(0f, -0.04f, 0f, -0.04f)]
        [TestCase(0f, 0.19f, 0f, 0.19f)]
        public void ASlowInsect_GoesSlowlyAsideAndBack(float right, float ahead, float leftRight, float leftAhead)
        {
            const float heading = 0.4f;
            FlightCommand limited = Limit(FlightCommand.Fly(right * Along(heading + 0.5f * math.PI) + ahead * Along(heading)),
                Situation(0.1f * Along(2f), heading));
            Assert.That(math.distance(limited.velocity, leftRight * Along(heading + 0.5f * math.PI) + leftAhead * Along(heading)),
                Is.LessThan(1e-5f));
            Assert.That(limited.heading, Is.NaN);
        }

        // Faster than 0.2 m/s a slow insect turns its nose there first: 0.3 rad ahead of itself, at 0.05 m/s until it is within 0.5 rad.
        [Test]
        public void ASlowInsect_ThatIsToGoFast_TurnsFirst([Values(-3f, -0.6f, -0.45f, -0.2f, 0.2f, 0.45f, 0.6f, 3f)] float off)
        {
            const float heading = 1f;
            FlightCommand limited = Limit(FlightCommand.Fly(Along(heading + off), 5f), Situation(0.2f * Along(0f), heading));
            Assert.That(Headings.Wrap(limited.heading - heading), Is.EqualTo(math.clamp(off, -0.3f, 0.3f)).Within(1e-5f));
            float ahead = math.dot(limited.velocity, Along(heading)), aside = math.dot(limited.velocity, Along(heading + 0.5f * math.PI));
            if (math.abs(off) > 0.5f)
            {
                Assert.That(math.length(limited.velocity), Is.InRange(0.03f, 0.0501f));
                Assert.That(math.sign(aside), Is.EqualTo(math.sign(off)));
            }
            else
            {
                Assert.That(ahead, Is.EqualTo(math.cos(off)).Within(1e-5f));
                Assert.That(aside, Is.EqualTo(math.clamp(math.sin(off), -0.12f, 0.12f)).Within(1e-5f));
            }
        }

        [Test]
        public void AWantedHeading_IsTurnedToFirst([Values(-2f, -0.4f, 0.2f, 0.4f, 2f)] float off)
        {
            FlightCommand limited = Limit(FlightCommand.Fly(new float3(0f, 0f, 0.1f), off), Situation(default, 0f));
            Assert.That(limited.heading, Is.EqualTo(math.clamp(off, -0.3f, 0.3f)).Within(1e-6f));
            Assert.That(limited.velocity.z, Is.EqualTo(math.abs(off) > 0.5f ? 0.05f : 0.1f).Within(1e-6f));
        }

        // A heading may spin while the insect flies on: across its nose it is never faster than 0.12 m/s.
        [Test]
        public void TheNose_TurnsNoFartherFromTheWay_ThanFlightAsideAllows([Values(0.13f, 0.2f, 0.3f, 1f)] float flown,
            [Values(-3f, -1f, -0.05f, 0.05f, 1f, 3f)] float off)
        {
            const float course = 2f;
            FlightCommand limited = Limit(FlightCommand.Fly(flown * Along(course), course + off), Situation(flown * Along(course), course));
            float aside = flown * math.sin(Headings.Wrap(limited.heading - course));
            float most = flown > 0.25f ? 0.12f : math.min(0.12f, flown * math.sin(0.3f));
            Assert.That(aside, Is.EqualTo(math.sign(off) * math.min(most, flown * math.sin(math.min(math.abs(off), 0.5f * math.PI))))
                .Within(1e-4f));
            Assert.That(math.abs(Headings.Wrap(limited.heading - course)), Is.LessThan(1.2f));
        }

        // Up 0.03 m/s and 0.6 for each m/s beyond slow flight; down 0.15, from 0.8 m/s on half of what is more than 0.5; 0.03 while it
        // turns.
        [TestCase(0f, 0.03f, -0.15f)]
        [TestCase(0.25f, 0.03f, -0.15f)]
        [TestCase(0.5f, 0.18f, -0.15f)]
        [TestCase(1.3f, 0.66f, -0.4f)]
        public void ClimbAndSink_GrowWithTheSpeed(float flown, float climb, float sink)
        {
            FlightSituation situation = Situation(flown * Along(0.3f), 0.3f);
            Assert.That(Limit(FlightCommand.Fly(new float3(0f, 9f, 0f)), situation).velocity.y, Is.EqualTo(climb).Within(1e-6f));
            Assert.That(Limit(FlightCommand.Fly(new float3(0f, -9f, 0f)), situation).velocity.y, Is.EqualTo(sink).Within(1e-6f));
            Assert.That(Limit(FlightCommand.Fly(new float3(0f, -0.1f, 0f)), situation).velocity.y,
                Is.EqualTo(-0.1f).Within(1e-6f));
        }

        // Down, aside and back at once stay within an ellipsoid of 0.15, 0.12 and 0.06 m/s; 0.03 m/s down is left.
        [Test]
        public void ASlowInsect_SinksLessWhereItGoesAsideOrBack([Values(0f, 0.06f, 0.1f, 0.12f)] float aside,
            [Values(-0.06f, -0.04f, 0f, 0.1f)] float ahead)
        {
            if (aside == 0f && ahead == 0f)
                return;
            float sink = -Limit(FlightCommand.Fly(new float3(aside, -9f, ahead)), Situation(default, 0f)).velocity.y;
            float back = math.min(ahead, 0f), all = (sink * sink / 0.0225f) + (aside * aside / 0.0144f) + (back * back / 0.0036f);
            if (sink > 0.0301f)
                Assert.That(all, Is.EqualTo(1f).Within(1e-4f));
            else
                Assert.That(all, Is.GreaterThan(0.999f));
        }

        // What swims is as slow as its top speed: along the ground the same limits at a share of the speeds.
        [Test]
        public void OfASlowKind_TheSpeedsAreAShare([Values(0.2f, 0.5f)] float share, [Values(0.5f, 1.5f, 3f)] float off)
        {
            float3 velocity = share * Along(off), whole = Along(off), way = 0.4f * Along(0f);
            float heading = float.NaN, other = float.NaN;
            CommandGuard.Limit(ref velocity, ref heading, share * way, 0f, share);
            CommandGuard.Limit(ref whole, ref other, way, 0f, 1f);
            Assert.That(math.distance(velocity.xz, share * whole.xz), Is.LessThan(1e-5f));
        }

        [Test]
        public void AnInsectThatTurns_SinksNoMore()
        {
            FlightCommand limited = Limit(FlightCommand.Fly(new float3(0f, -9f, -1f)), Situation(default, 0f));
            Assert.That(limited.velocity.y, Is.EqualTo(-0.03f).Within(1e-6f));
        }

        [Test]
        public void ATurnedOrMirroredScene_IsLimitedTheSame([Values(false, true)] bool mirrored)
        {
            float by = mirrored ? 0f : 2.2f;
            float3 side = mirrored ? new float3(-1f, 1f, 1f) : 1f;
            var turn = quaternion.AxisAngle(new float3(0f, 1f, 0f), by);
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float3 wanted = random.NextFloat(0f, 1.3f) * random.NextFloat3(-1f, 1f),
                    flown = random.NextFloat(0f, 1f) * random.NextFloat3(-1f, 1f);
                float heading = random.NextBool() ? random.NextFloat(-3f, 3f) : float.NaN, own = random.NextFloat(-3f, 3f);
                FlightCommand one = Limit(FlightCommand.Fly(wanted, heading), Situation(flown, own));
                FlightCommand other = Limit(
                    FlightCommand.Fly(math.rotate(turn, side * wanted), mirrored ? -heading : heading + by),
                        Situation(math.rotate(turn, side * flown), mirrored ? -own : own + by));
                Assert.That(math.distance(math.rotate(turn, side * one.velocity), other.velocity), Is.LessThan(1e-4f), $"seed {seed}");
                Assert.That(float.IsNaN(one.heading) ? !float.IsNaN(other.heading)
                    : math.abs(Headings.Wrap((mirrored ? -one.heading : one.heading + by) - other.heading)) > 1e-4f, Is.False,
                    $"seed {seed}");
            }
        }

        private static FlightSituation Situation(float3 flown, float heading) =>
            new FlightSituation { referenceVelocity = flown, velocity = 9f, heading = heading };

        private static FlightCommand Limit(FlightCommand command, FlightSituation situation)
        {
            CommandGuard.Limit(ref command.velocity, ref command.heading, situation.referenceVelocity, situation.heading, 1f);
            return command;
        }

        private static float3 Along(float course) => new float3(math.sin(course), 0f, math.cos(course));
    }
}
