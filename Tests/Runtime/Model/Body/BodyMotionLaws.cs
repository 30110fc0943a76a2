using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>A rigid body by itself: what it keeps, how it falls, and how air slows it down.</summary>
    public sealed class BodyMotionLaws
    {
        private const float k_Mass = 4e-4f;

        // Torque-free motion of a body with three different moments of inertia, about the middle axis too, where it tumbles.
        [Test]
        public void ASpinningBody_KeepsItsEnergyAndAngularMomentum([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            FlyingBody body = Body(ref random);
            body.spin = random.NextFloat(10f, 40f) * random.NextFloat3Direction();
            double energy = Energy(body), least = energy, most = energy;
            float3 momentum = Momentum(body);
            float off = 0f;
            for (int step = 0; step < 2000; step++)
            {
                Move(ref body, default, 5e-4f);
                least = math.min(least, Energy(body));
                most = math.max(most, Energy(body));
                off = math.max(off, math.length(Momentum(body) - momentum));
            }

            Assert.That((most - least) / energy, Is.LessThan(1e-3), "energy");
            Assert.That(off / math.length(momentum), Is.LessThan(2e-3f), "angular momentum");
        }

        // About its axis a body with two equal moments of inertia precesses by ω (J₃ − J₁) / J₁ (Euler).
        [Test]
        public void ASymmetricTop_PrecessesAsEulerSays([Values(0.4f, 2.5f)] float slenderness)
        {
            const float side = 2e-8f, spin = 30f, aside = 3f, h = 2e-4f;
            var random = Random.CreateFromIndex(5);
            FlyingBody body = Body(ref random);
            body.rotation = quaternion.identity;
            body.inertia = new float3x3(side, 0f, 0f, 0f, side, 0f, 0f, 0f, slenderness * side);
            body.spin = new float3(aside, 0f, spin);
            float rate = spin * (slenderness - 1f);
            for (int step = 0; step < 500; step++)
                Move(ref body, default, h);
            math.sincos(rate * 500 * h, out float sin, out float cos);
            Assert.That(math.distance(body.spin, new float3(aside * cos, aside * sin, spin)), Is.LessThan(5e-3f * spin));
        }

        [Test]
        public void ABodyWithoutAir_Falls_HoweverItTurns([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            const float h = 1e-3f, time = 0.4f;
            var random = Random.CreateFromIndex(seed);
            FlyingBody body = Body(ref random);
            body.drag = default;
            body.spin = random.NextFloat3(-20f, 20f);
            body.weight = new float3(0.3f, -9.81f, 0.5f);
            float3 velocity = body.velocity = random.NextFloat3(-1f, 1f);
            for (int step = 0; step < 400; step++)
                Move(ref body, default, h);
            Assert.That(math.distance(body.velocity, velocity + time * body.weight), Is.LessThan(1e-4f));
            Assert.That(math.distance(body.position, velocity * time + 0.5f * time * time * body.weight), Is.LessThan(1e-4f));
            Assert.That(math.length(body.force) / 400f, Is.LessThan(1e-3f * k_Mass), "what falls freely feels no force");
        }

        // v = v_t tanh(g t / v_t), v_t² = m g / k, along whichever of its axes it falls; k is that of this axis.
        [Test]
        public void AFallingBody_IsHeldBackByItsHull_AxisByAxis([Values(0, 1, 2)] int axis)
        {
            const float h = 1e-3f, gravity = 9.81f;
            var random = Random.CreateFromIndex(2);
            FlyingBody body = Body(ref random);
            body.spin = default;
            float3 along = default;
            along[axis] = 1f;
            body.rotation = BodyMotion.Turn(new float3(0.4f, -1f, 0.7f));
            float3 down = math.rotate(body.rotation, along);
            body.weight = gravity * down;
            float terminal = math.sqrt(k_Mass * gravity / body.drag[axis]);
            for (int step = 1; step <= 400; step++)
            {
                Move(ref body, default, h);
                float expected = terminal * (float)System.Math.Tanh(gravity * step * h / terminal);
                Assert.That(math.distance(body.velocity, expected * down), Is.LessThan(2e-3f * terminal), $"step {step}");
            }
        }

        // Against the wind the speed s falls as s₀ / (1 + k s₀ t / m).
        [Test]
        public void AWind_TakesABodyAlong()
        {
            const float h = 1e-3f;
            var random = Random.CreateFromIndex(3);
            FlyingBody body = Body(ref random);
            body.spin = default;
            body.drag = 2e-4f;
            body.wind = new float3(1f, -2f, 2f);
            for (int step = 0; step < 300; step++)
                Move(ref body, default, h);
            float left = 3f / (1f + 2e-4f * 3f * 0.3f / k_Mass);
            Assert.That(math.distance(body.velocity, body.wind * (1f - left / 3f)), Is.LessThan(3e-3f));
        }

        // Forces F = −K v of a slow body are taken where it was predicted to be, and K carries them to the middle of the step: (M +
        // hK/2) v₁ = (M − hK/2) v₀.
        [Test]
        public void DampingByTheWings_IsTheMidpointRules([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            const float h = 2e-3f, slow = 1e-4f;
            var random = Random.CreateFromIndex(seed);
            FlyingBody body = Body(ref random);
            body.drag = default;
            body.rotation = quaternion.identity;
            double[] v = new double[6];
            for (int k = 0; k < 3; k++)
            {
                v[k] = body.velocity[k] = slow * random.NextFloat(-1f, 1f);
                v[k + 3] = body.spin[k] = 0.1f * slow * random.NextFloat(-1f, 1f);
            }

            Symmetric6 damping = Damping(ref random, 0.1f, 3e-5f, 1e-6f);
            double[,] k6 = Whole(damping), mass = new double[6, 6];
            for (int i = 0; i < 3; i++)
            {
                mass[i, i] = k_Mass;
                for (int j = 0; j < 3; j++)
                    mass[i + 3, j + 3] = body.inertia[j][i];
            }

            for (int step = 0; step < 20; step++)
            {
                Damp(ref body, damping, h);
                v = Midpoint(mass, k6, v, h);
            }

            for (int i = 0; i < 3; i++)
            {
                Assert.That(body.velocity[i], Is.EqualTo(v[i]).Within(2e-3 * slow), $"velocity {i}");
                Assert.That(body.spin[i], Is.EqualTo(v[i + 3]).Within(2e-4 * slow), $"spin {i}");
            }
        }

        [Test]
        public void AirAndAid_ChangeMomentumByTheirImpulse([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            const float h = 1e-3f;
            var random = Random.CreateFromIndex(seed);
            FlyingBody body = Body(ref random);
            body.spin = default;
            body.drag = default;
            body.aidForce = 1e-3f * random.NextFloat3(-1f, 1f);
            body.aidMoment = 1e-6f * random.NextFloat3(-1f, 1f);
            var air = new BodyAir { force = 1e-3f * random.NextFloat3(-1f, 1f), moment = 1e-6f * random.NextFloat3(-1f, 1f) };
            quaternion before = body.rotation;
            float3 force = math.rotate(before, air.force) + body.aidForce, moment = air.moment + body.aidMoment;
            Move(ref body, air, h);
            Assert.That(math.distance(body.velocity, force * h / k_Mass), Is.LessThan(1e-3f * math.length(force) * h / k_Mass));
            Assert.That(math.distance(math.mul(body.inertia, body.spin), moment * h), Is.LessThan(1e-3f * math.length(moment) * h));
            Assert.That(math.distance(body.force, force), Is.LessThan(1e-3f * math.length(force)),
                "the reading of the force is all but the weight");
            Assert.That(math.distance(body.moment, air.moment), Is.LessThan(1e-12f), "that of the moment the wings' alone");
        }

        [Test]
        public void WhatIsNotFinite_MovesNoBody([Values(float.NaN, float.PositiveInfinity)] float value, [Values(false, true)] bool turning)
        {
            var random = Random.CreateFromIndex(4);
            FlyingBody body = Body(ref random), before = body;
            Move(ref body, turning ? new BodyAir { moment = value } : new BodyAir { force = value }, 1e-3f);
            Assert.That(body.velocity, Is.EqualTo(before.velocity));
            Assert.That(body.spin, Is.EqualTo(before.spin));
            Assert.That(body.position, Is.EqualTo(before.position));
            Assert.That(body.rotation, Is.EqualTo(before.rotation));
        }

        [Test]
        public void TurnAndLog_LeadThereAndBack_TheShortWay([Values(1u, 2u, 3u, 4u, 5u, 6u)] uint seed)
        {
            var random = Random.CreateFromIndex(seed);
            float3 axis = random.NextFloat3Direction();
            foreach (float angle in new[] { 0f, 1e-5f, 2e-4f, 0.3f, 1.5f, 3f })
            {
                quaternion turn = BodyMotion.Turn(angle * axis);
                var expected = Rotation.About(axis.x, axis.y, axis.z, angle * 180.0 / System.Math.PI);
                Assert.That(math.distance(turn.value,
                    new float4((float)expected.x, (float)expected.y, (float)expected.z, (float)expected.w)), Is.LessThan(1e-6f));
                Assert.That(math.distance(BodyMotion.Log(turn), angle * axis), Is.LessThan(3e-6f), $"{angle}");
                Assert.That(math.distance(BodyMotion.Log(new quaternion(-turn.value)), angle * axis), Is.LessThan(3e-6f),
                    "the other sign is the same rotation");
            }

            Assert.That(math.distance(BodyMotion.Log(BodyMotion.Turn(4f * axis)), (4f - 2f * math.PI) * axis), Is.LessThan(1e-5f));
        }

        // A float of a kilometre has steps of 0.06 mm: without what rounding left out, ten thousand steps of 0.01 mm lead nowhere.
        [Test]
        public void FarFromTheOrigin_NoSmallStepIsLost()
        {
            FlyingBody body = default;
            body.position = new float3(1000f, -1000f, 1000f);
            for (int step = 0; step < 10000; step++)
                body.Move(new float3(1e-5f, 2e-5f, -1e-5f));
            Assert.That(math.distance(body.position, new float3(1000.1f, -999.8f, 999.9f)), Is.LessThan(2e-4f));
        }

        private static FlyingBody Body(ref Random random) => new FlyingBody
        {
            mass = k_Mass,
            inertia = Inertia(ref random),
            drag = new float3(2e-4f, 3e-4f, 1e-4f),
            rotation = random.NextQuaternionRotation(),
            length = 0.06f,
        };

        private static float3x3 Inertia(ref Random random)
        {
            var axes = new float3x3(random.NextQuaternionRotation());
            var principal = new float3x3(random.NextFloat(1e-8f, 2e-8f), 0f, 0f, 0f, random.NextFloat(3e-8f, 4e-8f), 0f, 0f, 0f,
                random.NextFloat(4.5e-8f, 5e-8f));
            return math.mul(math.mul(axes, principal), math.transpose(axes));
        }

        private static Symmetric6 Damping(ref Random random, float force, float coupling, float moment)
        {
            float3x3 a = Random3x3(ref random), b = Random3x3(ref random);
            return new Symmetric6
            {
                uu = force * math.mul(a, math.transpose(a)),
                uw = coupling * Random3x3(ref random),
                ww = moment * math.mul(b, math.transpose(b)),
            };
        }

        private static float3x3 Random3x3(ref Random random) =>
            new float3x3(random.NextFloat3(-1f, 1f), random.NextFloat3(-1f, 1f), random.NextFloat3(-1f, 1f));

        private static double[,] Whole(in Symmetric6 matrix)
        {
            double[,] whole = new double[6, 6];
            for (int i = 0; i < 3; i++)
            {
                for (int j = 0; j < 3; j++)
                {
                    whole[i, j] = matrix.uu[j][i];
                    whole[i, j + 3] = matrix.uw[j][i];
                    whole[j + 3, i] = matrix.uw[j][i];
                    whole[i + 3, j + 3] = matrix.ww[j][i];
                }
            }

            return whole;
        }

        private static double[] Midpoint(double[,] mass, double[,] damping, double[] v, double h)
        {
            double[,] system = new double[6, 7];
            for (int i = 0; i < 6; i++)
            {
                for (int j = 0; j < 6; j++)
                {
                    system[i, j] = mass[i, j] + 0.5 * h * damping[i, j];
                    system[i, 6] += (mass[i, j] - 0.5 * h * damping[i, j]) * v[j];
                }
            }

            return Dense.Solve(system);
        }

        private static void Damp(ref FlyingBody body, in Symmetric6 damping, float h)
        {
            BodyMotion.Predict(ref body, h);
            float3 velocity = math.rotate(math.conjugate(body.middleRotation), body.middleVelocity);
            float3 force = -(math.mul(damping.uu, velocity) + math.mul(damping.uw, body.middleSpin));
            float3 moment = -(math.mul(math.transpose(damping.uw), velocity) + math.mul(damping.ww, body.middleSpin));
            BodyMotion.Step(ref body, new BodyAir { force = force, moment = moment, damping = damping }, h);
        }

        private static void Move(ref FlyingBody body, in BodyAir air, float h)
        {
            BodyMotion.Predict(ref body, h);
            BodyMotion.Step(ref body, air, h);
        }

        private static double Energy(in FlyingBody body) => 0.5 * math.dot(body.spin, math.mul(body.inertia, body.spin));

        private static float3 Momentum(in FlyingBody body) => math.rotate(body.rotation, math.mul(body.inertia, body.spin));
    }
}
