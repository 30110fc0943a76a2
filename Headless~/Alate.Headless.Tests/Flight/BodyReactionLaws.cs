using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.FreeFlights
{
    /// <summary>Laws of one substep of a body that its wings move, beside that of one with wings that keep their places.</summary>
    public sealed class BodyReactionLaws
    {
        private const float k_Substep = 1e-5f;

        // Air, damping, drag, weight, and aid: with wings that stay where they are on average, both steps are the same.
        [Test]
        public void WithWingsThatKeepTheirPlaces_TheBodyMovesAsOneOfOnePiece([Range(1, 20)] int seed)
        {
            var random = Random.CreateFromIndex((uint)seed);
            FlyingBody one = Body(ref random), other = one;
            BodyAir air = Air(ref random);
            var still = new BodyMasses { inertia = one.inertia };
            BodyMotion.Step(ref one, air, k_Substep);
            BodyReaction.Step(ref other, air, still, k_Substep);

            AssertNear(other.acceleration, one.acceleration, "acceleration");
            AssertNear(other.spinRate, one.spinRate, "rate of turning");
            AssertNear(other.force, one.force, "force");
            AssertNear(other.moment, one.moment, "moment");
            Assert.That(math.distance(other.velocity, one.velocity), Is.LessThan(1e-6f));
            Assert.That(math.distance(other.position, one.position), Is.LessThan(1e-9f));
            Assert.That(math.distance(other.rotation.value, one.rotation.value), Is.LessThan(1e-6f));
        }

        // Gravity turns nothing about the centre of mass: where that lies ahead of the body's own, both fall alike.
        [Test]
        public void WhatFalls_TurnsAboutNothing_WhereverItsMassesLie()
        {
            var random = Random.CreateFromIndex(3u);
            FlyingBody body = Body(ref random);
            (body.rotation, body.middleRotation, body.spin, body.middleSpin) = (quaternion.identity, quaternion.identity, default, default);
            body.aidForce = body.aidMoment = body.drag = body.acceleration = body.spinRate = default;
            var ahead = new BodyMasses { first = new float3(0f, 0f, 1e-3f * body.mass), inertia = 100f * body.inertia };
            BodyReaction.Step(ref body, default, ahead, k_Substep);
            Assert.That(math.length(body.spinRate), Is.LessThan(1e-3f));
            AssertNear(body.acceleration, body.weight, "fall");
        }

        [Test]
        public void AWingThatBroke_DoesNotHoldTheBodyForGood()
        {
            var random = Random.CreateFromIndex(4u);
            FlyingBody body = Body(ref random);
            var still = new BodyMasses { inertia = body.inertia };
            BodyMasses broken = still;
            broken.linear = float.NaN;
            BodyReaction.Step(ref body, default, still, k_Substep);
            FlyingBody before = body;
            BodyReaction.Step(ref body, default, broken, k_Substep);
            Assert.That(math.all(body.velocity == before.velocity), "it waits");
            BodyReaction.Step(ref body, default, still, k_Substep);
            Assert.That(math.distance(body.velocity, before.velocity), Is.GreaterThan(0f).And.LessThan(0.1f));

            // One that was held then knows masses that are no numbers.
            before = body;
            body.masses = broken;
            for (int step = 0; step < 2; step++)
                BodyReaction.Step(ref body, default, still, k_Substep);
            Assert.That(math.distance(body.velocity, before.velocity), Is.GreaterThan(0f).And.LessThan(0.1f));
        }

        private static void AssertNear(float3 ours, float3 wanted, string what) =>
            Assert.That(math.distance(ours, wanted), Is.LessThan(2e-3f * math.length(wanted)), what);

        private static FlyingBody Body(ref Random random)
        {
            quaternion rotation = random.NextQuaternionRotation();
            float3 spin = random.NextFloat3(-20f, 20f);
            var body = new FlyingBody
            {
                mode = BodyMode.Free,
                mass = 5e-4f,
                inertia = new float3x3(5e-8f, 1e-9f, 0f, 1e-9f, 7e-8f, 2e-9f, 0f, 2e-9f, 6e-8f),
                drag = random.NextFloat3(1e-4f, 1e-3f),
                weight = new float3(0f, -9.81f, 0f),
                wind = random.NextFloat3(-1f, 1f),
                rotation = rotation,
                velocity = random.NextFloat3(-1f, 1f),
                spin = spin,
                acceleration = random.NextFloat3(-10f, 10f),
                spinRate = random.NextFloat3(-500f, 500f),
                aidForce = random.NextFloat3(-1e-3f, 1e-3f),
                aidMoment = random.NextFloat3(-1e-5f, 1e-5f),
            };
            BodyMotion.Predict(ref body, k_Substep);
            return body;
        }

        private static BodyAir Air(ref Random random)
        {
            var air = new BodyAir
            {
                force = random.NextFloat3(-1e-2f, 1e-2f),
                moment = random.NextFloat3(-1e-4f, 1e-4f),
                damping = new Symmetric6
                {
                    uu = float3x3.Scale(random.NextFloat3(1e-3f, 1e-2f)),
                    ww = float3x3.Scale(random.NextFloat3(1e-6f, 1e-5f)),
                },
            };
            return air;
        }
    }
}
