using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Flight
{
    /// <summary>Speeds along a path: before corners, round them, beside the way and at its end.</summary>
    public sealed class PathLaws
    {
        private const float k_Speed = 1.2f, k_Acceleration = 2.5f;

        // An arc that cuts the corner by 0.15 m has the radius 0.15 / (1/cos(turn/2) − 1), is flown at √(a r), begins r tan(turn/2)
        // before the corner, and is steered into
        // as much earlier as the insect takes to answer: 0.2 s of what it flies across the new way.
        [Test]
        public void ACorner_IsBegunBeforeItsArc_ByTheTimeOfTheAnswer([Values(60f, 90f, 110f)] float degrees, [Values(1f, 10f)] float units)
        {
            float half = 0.5f * math.radians(degrees), radius = 0.15f / (1f / math.cos(half) - 1f);
            float speed = math.min(math.sqrt(k_Acceleration * radius), k_Speed);
            float lead = speed * speed / k_Acceleration * math.tan(half) + 0.2f * speed * math.sin(half);
            Vector3[] points = Corner(degrees, units);
            Assert.That(Fly(points, 4f - lead - 0.01f, units, out float3 before), Is.EqualTo(1));
            Assert.That(Fly(points, 4f - lead + 0.01f, units, out float3 after), Is.EqualTo(2));
            Assert.That(math.length(before), Is.EqualTo(math.sqrt(speed * speed + k_Acceleration
                * 0.01f)).Within(1e-3f).Or.EqualTo(k_Speed).Within(1e-3f));
            Assert.That(math.normalize(before).z, Is.EqualTo(1f).Within(1e-5f));
            Assert.That(math.distance(after, speed * Along(math.radians(degrees))), Is.LessThan(1e-4f),
                "round the corner as fast as its arc");
        }

        // v² = v₀² + 2 (a/2) d: half of the acceleration is left for the turn.
        [Test]
        public void BeforeACorner_TheInsectBrakesInTime([Values(0.1f, 0.2f, 0.3f)] float left)
        {
            Vector3[] points = Corner(90f, 1f);
            float radius = 0.15f / (math.sqrt(2f) - 1f), speed = math.sqrt(k_Acceleration * radius),
                lead = radius + 0.2f * speed * math.sqrt(0.5f);
            Fly(points, 4f - lead - left, 1f, out float3 velocity);
            Assert.That(velocity.z, Is.EqualTo(math.min(math.sqrt(speed * speed + k_Acceleration * left), k_Speed)).Within(1e-3f));
        }

        [Test]
        public void ATurnBack_IsFlownSlowly_AndNotBegunTooEarly()
        {
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f), new Vector3(0.01f, 0f, 0f) };
            float lead = 0.3f + new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration).StoppingDistance(0.2f);
            Assert.That(Fly(points, 4f - lead - 0.01f, 1f, out _), Is.EqualTo(1));
            Fly(points, 3.99f, 1f, out float3 velocity);
            Assert.That(velocity.z, Is.EqualTo(-0.2f).Within(0.01f));
        }

        // Half of the turn is a right angle, whose cosine is a little below nothing.
        [Test]
        public void AWayStraightBack_IsFlownAsSlowlyAsACorner([Values(0.05f, 0.2f)] float left)
        {
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f), Vector3.zero };
            var limits = new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration);
            var follower = new PathFollower();
            follower.Along(At(default, 1f), points, false, k_Speed);
            float lead = 0.2f * 0.2f / k_Acceleration * 2f + 0.2f * 0.2f;
            float3 before = follower.Along(At(new float3(0f, 0f, 4f - lead - left), 1f), points, false, k_Speed);
            Assert.That(follower.Next, Is.EqualTo(1));
            Assert.That(before.z, Is.EqualTo(math.sqrt(0.2f * 0.2f + limits.Acceleration * left)).Within(1e-3f));
            Assert.That(follower.Along(At(new float3(0f, 0f, 4f - 0.5f * lead), 1f), points, false, k_Speed).z,
                Is.EqualTo(-0.2f).Within(1e-3f));
        }

        // However slowly it brakes, it turns no earlier than it needs to stop, and 0.3 m.
        [Test]
        public void OneThatBrakesSlowly_GoesIntoACornerNoEarlierThanItNeeds([Values(0.05f, 0.1f)] float acceleration)
        {
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f), new Vector3(0.01f, 0f, 0f) };
            var limits = new FlightLimits(1.3f, -0.3f, 0.3f, acceleration);
            float lead = limits.StoppingDistance(0.2f) + 0.3f;
            foreach (float beyond in new[] { -0.01f, 0.01f })
            {
                var follower = new PathFollower();
                FlightSituation begin = At(default, 1f), there = At(new float3(0f, 0f, 4f - lead + beyond), 1f);
                begin.limits = there.limits = limits;
                follower.Along(begin, points, false, k_Speed);
                follower.Along(there, points, false, k_Speed);
                follower.Along(there, points, false, k_Speed);
                Assert.That(follower.Next, Is.EqualTo(beyond < 0f ? 1 : 2));
            }
        }

        [Test]
        public void AtTheEnd_TheInsectIsAsSlowAsItCanStop([Values(0.02f, 0.2f, 0.6f, 2f)] float left)
        {
            var limits = new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration);
            var follower = new PathFollower();
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f) };
            follower.Along(At(default, 1f), points, false, k_Speed);
            float3 velocity = follower.Along(At(new float3(0f, 0f, 4f - left), 1f), points, false, k_Speed);
            Assert.That(velocity.z, Is.EqualTo(math.min(math.min(k_Speed, left), limits.SpeedToStopWithin(left))).Within(1e-4f));
            Assert.That(follower.HasArrived, Is.EqualTo(left < 0.05f));
            velocity = follower.Along(At(new float3(0f, 0f, 4.1f), 1f), points, false, k_Speed);
            Assert.That(velocity.z, Is.EqualTo(-0.1f).Within(1e-4f), "one that is beyond it comes back");
        }

        [Test]
        public void BesideTheWay_TheInsectComesBackToIt([Values(-0.5f, -0.1f, 0.1f, 0.5f, 3f)] float aside, [Values(1f, 7f)] float units)
        {
            var limits = new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration);
            var follower = new PathFollower();
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 40f * units) };
            follower.Along(At(default, units), points, false, k_Speed);
            float3 velocity = follower.Along(At(units * new float3(aside, 0f, 10f), units), points, false, k_Speed);
            float back = math.min(math.min(math.abs(aside), limits.SpeedToStopWithin(math.abs(aside))), 0.5f * k_Speed);
            Assert.That(velocity.x, Is.EqualTo(-math.sign(aside) * back).Within(1e-4f));
            Assert.That(velocity.z, Is.EqualTo(k_Speed).Within(1e-4f));
        }

        [Test]
        public void APointThatMoves_IsFlownAfter([Values(0.05f, 0.5f, 4f)] float left, [Values(1f, 7f)] float units)
        {
            var limits = new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration);
            var moves = new float3(0.2f, -0.1f, 0f);
            float3 direction = math.normalize(new float3(1f, 2f, -2f));
            float3 velocity = PathFollower.Towards(At(default, units), units * left * direction, moves, 0.9f);
            float closing = math.min(math.min(left, limits.SpeedToStopWithin(left)), 0.9f);
            Assert.That(math.distance(velocity, moves + closing * direction), Is.LessThan(1e-5f));
        }

        // Half the stopping distance before the first point the way along the path begins.
        [Test]
        public void TheFirstPoint_IsFlownTo_UntilItIsNear()
        {
            var follower = new PathFollower();
            Vector3[] points = { new Vector3(0f, 0f, 5f), new Vector3(5f, 0f, 5f) };
            float near = 0.5f * (k_Speed * k_Speed / (2f * k_Acceleration) + 0.2f * k_Speed);
            float3 velocity = follower.Along(At(new float3(0f, 0f, 5f - near - 0.01f), 1f), points, false, k_Speed);
            Assert.That(velocity.z, Is.EqualTo(math.length(velocity)).Within(1e-5f));
            follower.Along(At(new float3(0f, 0f, 5f - near - 0.01f), 1f), points, false, k_Speed);
            Assert.That(follower.Next, Is.Zero);
            follower.Along(At(new float3(0f, 0f, 5f - near + 0.01f), 1f), points, false, k_Speed);
            velocity = follower.Along(At(new float3(0f, 0f, 5f - near + 0.01f), 1f), points, false, k_Speed);
            Assert.That(follower.Next, Is.EqualTo(1));
            Assert.That(velocity.x, Is.GreaterThan(0.5f));
            follower.Restart();
            follower.Along(At(default, 1f), points, false, k_Speed);
            Assert.That(follower.Next, Is.Zero, "it begins again");
        }

        [Test]
        public void APathThatBecameShorter_IsBegunAgain()
        {
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f), new Vector3(0f, 0f, 8f), new Vector3(0f, 0f, 12f) };
            var follower = new PathFollower();
            foreach (float along in new[] { 0f, 0f, 4f, 4f, 8f, 8f, 9f })
                follower.Along(At(new float3(0f, 0f, along), 1f), points, false, k_Speed);
            Assert.That(follower.Next, Is.EqualTo(3));

            Vector3[] shorter = { new Vector3(0f, 0f, 5f), new Vector3(5f, 0f, 5f) };
            float3 velocity = follower.Along(At(new float3(0f, 0f, 9f), 1f), shorter, false, k_Speed);
            Assert.That(follower.Next, Is.Zero);
            Assert.That(velocity.z, Is.EqualTo(-k_Speed).Within(1e-4f), "to its first point");
        }

        [Test]
        public void OnePoint_IsStayedAt([Values(0.04f, 0.06f)] float left)
        {
            var follower = new PathFollower();
            follower.Along(At(new float3(left, 0f, 0f), 1f), new[] { Vector3.zero }, false, k_Speed);
            Assert.That(follower.HasArrived, Is.EqualTo(left < 0.05f));
            follower.Restart();
            Assert.That(follower.HasArrived, Is.False);
        }

        [Test]
        public void NoSpeed_IsAboveTheInsects()
        {
            var follower = new PathFollower();
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 40f) };
            follower.Along(At(default, 1f), points, false, 5f);
            Assert.That(follower.Along(At(new float3(0f, 0f, 10f), 1f), points, false, 5f).z, Is.EqualTo(1.3f));
        }

        [Test]
        public void ALoop_GoesOnWithItsFirstPoint()
        {
            var follower = new PathFollower();
            Vector3[] points = { Vector3.zero, new Vector3(0f, 0f, 4f), new Vector3(4f, 0f, 0f) };
            follower.Along(At(default, 1f), points, true, k_Speed);
            foreach (int next in new[] { 1, 2, 0, 1, 2 })
            {
                follower.Along(At(0.5f * (points[(next + 2) % 3] + points[next]), 1f), points, true, k_Speed);
                Assert.That(follower.Next, Is.EqualTo(next));
                Assert.That(follower.HasArrived, Is.False);
                follower.Along(At(points[next], 1f), points, true, k_Speed);
            }
        }

        // The point that is flown to next, and the velocity, some metres along the first stretch.
        private static int Fly(Vector3[] points, float along, float units, out float3 velocity)
        {
            var follower = new PathFollower();
            follower.Along(At(default, units), points, false, k_Speed);
            velocity = follower.Along(At(new float3(0f, 0f, along * units), units), points, false, k_Speed);
            return follower.Next;
        }

        private static Vector3[] Corner(float degrees, float units) =>
            new[] { Vector3.zero, new Vector3(0f, 0f, 4f * units),
                (Vector3)(units * (new float3(0f, 0f, 4f) + 4f * Along(math.radians(degrees)))) };

        private static float3 Along(float course) => new float3(math.sin(course), 0f, math.cos(course));

        private static FlightSituation At(float3 position, float units) => new FlightSituation
        {
            position = position,
            unitsPerMetre = units,
            limits = new FlightLimits(1.3f, -0.3f, 0.3f, k_Acceleration),
        };
    }
}
