using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of the velocity that is taken from places.</summary>
    public sealed class MotionSamplerLaws
    {
        private const float k_Step = 0.01f, k_Finest = 0.01f, k_Jump = 0.5f, k_Turn = 60f;

        private static readonly Vector3 s_Velocity = new Vector3(2f, -3f, 4f), s_Rate = new Vector3(1f, 5f, -2f);

        [Test]
        public void AnEvenMotion_HasItsVelocityAndItsRate([Values(false, true)] bool negated)
        {
            MotionSampler sampler = default;
            for (int k = 0; k < 5; k++)
                Assert.That(Sample(ref sampler, k, negated && k % 2 == 1), Is.False);

            Assert.That((sampler.Velocity - s_Velocity).magnitude, Is.LessThan(1e-3f));
            Assert.That((sampler.AngularVelocity - s_Rate).magnitude, Is.LessThan(1e-2f), "a quaternion and its negative are one attitude");
        }

        // 1 − e^(−t/0.05 s) of the change after a time t.
        [Test]
        public void AnotherVelocity_IsTakenOverByAnExponential([Values(0.005f, 0.01f, 0.02f)] float dt)
        {
            MotionSampler sampler = default;
            Vector3 place = default;
            for (int k = 0; k < 3; k++)
                sampler.Sample(place += dt * Vector3.right, Quaternion.identity, dt, k_Finest, k_Jump, k_Turn);
            for (int k = 1; k * dt < 0.2f; k++)
            {
                sampler.Sample(place += dt * Vector3.forward, Quaternion.identity, dt, k_Finest, k_Jump, k_Turn);
                float share = 1f - math.exp(-k * dt / 0.05f);
                Assert.That((sampler.Velocity - new Vector3(1f - share, 0f, share)).magnitude, Is.LessThan(2e-3f), $"after {k * dt} s");
            }
        }

        [Test]
        public void AJump_ChangesNothing_AndTwoAlikeAreAMotion()
        {
            MotionSampler sampler = default;
            for (int k = 0; k < 5; k++)
                Sample(ref sampler, k, false);
            Vector3 velocity = sampler.Velocity, rate = sampler.AngularVelocity, place = 4f * k_Step * s_Velocity;
            Quaternion rotation = Rotation(4);

            Assert.That(sampler.Sample(place += 3f * Vector3.up, rotation, k_Step, k_Finest, k_Jump, k_Turn), Is.True);
            Assert.That((sampler.Velocity, sampler.AngularVelocity), Is.EqualTo((velocity, rate)));
            Assert.That(sampler.Sample(place += 3f * Vector3.up, rotation, k_Step, k_Finest, k_Jump, k_Turn), Is.False);
            Assert.That((sampler.Velocity - 3f / k_Step * Vector3.up).magnitude, Is.LessThan(0.1f));

            MotionSampler other = default;
            for (int k = 0; k < 5; k++)
                Sample(ref other, k, false);
            Assert.That(other.Sample(4f * k_Step * s_Velocity + 3f * Vector3.up, rotation, k_Step, k_Finest, k_Jump, k_Turn), Is.True);
            Assert.That(other.Sample(4f * k_Step * s_Velocity, rotation, k_Step, k_Finest, k_Jump, k_Turn), Is.True,
                "there and back are two");
            Assert.That(other.Velocity, Is.EqualTo(velocity));
        }

        [Test]
        public void JumpsWithEvenMotionBetweenThem_AreJumps()
        {
            MotionSampler sampler = default;
            Vector3 place = default;
            for (int k = 0; k < 20; k++)
            {
                bool jumps = k % 5 == 4;
                place += jumps ? 3f * Vector3.up : k_Step * Vector3.right;
                Assert.That(sampler.Sample(place, Quaternion.identity, k_Step, k_Finest, k_Jump, k_Turn), Is.EqualTo(jumps), $"step {k}");
            }
        }

        [Test]
        public void ATurnBeyondItsBound_IsAJump_InDegrees()
        {
            foreach ((float degrees, bool jumps) in new[] { (k_Turn - 2f, false), (k_Turn + 2f, true) })
            {
                MotionSampler sampler = default;
                for (int k = 0; k < 3; k++)
                    sampler.Sample(default, Quaternion.identity, k_Step, k_Finest, k_Jump, k_Turn);
                Assert.That(sampler.Sample(default, Quaternion.Euler(0f, degrees, 0f), k_Step, k_Finest, k_Jump, k_Turn),
                    Is.EqualTo(jumps), $"{degrees}°");
            }
        }

        [TestCase(-100f, true)]
        [TestCase(-30f, true)]
        [TestCase(45f, false)]
        [TestCase(100f, false)]
        [TestCase(155f, false)]
        [TestCase(165f, true)]
        public void OfTwoTurns_TheSecondIsAMotion_WhereItIsLikeTheFirst(float second, bool jumps)
        {
            MotionSampler sampler = default;
            for (int k = 0; k < 3; k++)
                sampler.Sample(default, Quaternion.identity, k_Step, k_Finest, k_Jump, k_Turn);
            Assert.That(sampler.Sample(default, Quaternion.Euler(0f, 100f, 0f), k_Step, k_Finest, k_Jump, k_Turn), Is.True);
            bool isSlow = Mathf.Abs(second) < k_Turn;
            Assert.That(sampler.Sample(default, Quaternion.Euler(0f, 100f + second, 0f), k_Step, k_Finest, k_Jump, k_Turn),
                Is.EqualTo(jumps && !isSlow), "one that is slow is none anyway");
        }

        [Test]
        public void WhatIsInterrupted_OrTakesNoTime_KeepsItsVelocity()
        {
            MotionSampler sampler = default;
            for (int k = 0; k < 5; k++)
                Sample(ref sampler, k, false);
            Vector3 velocity = sampler.Velocity;
            sampler.Interrupt();

            Assert.That(sampler.Sample(new Vector3(90f, 0f, 0f), Quaternion.Euler(0f, 120f, 0f), k_Step, k_Finest, k_Jump, k_Turn),
                Is.False);
            Assert.That(sampler.Sample(new Vector3(-90f, 0f, 0f), Quaternion.identity, 0f, k_Finest, k_Jump, k_Turn), Is.False);
            Assert.That(sampler.Velocity, Is.EqualTo(velocity));
            Assert.That(sampler.Sample(new Vector3(-90f, 0f, 0f) + k_Step * velocity, Rotation(1), k_Step, k_Finest, k_Jump, k_Turn),
                Is.False, "it starts from there");
        }

        // Neighbouring floats there are 0.0078 apart: a step alone would tell velocities by 0.78 units a second.
        [Test]
        public void FarFromTheOrigin_VelocitiesAreSampledOverLongerTimes()
        {
            MotionSampler sampler = default;
            var start = new Vector3(0f, 0f, 65600f);
            float worst = 0f;
            for (int k = 0; k < 300; k++)
            {
                sampler.Sample(start + k * k_Step * Vector3.forward, Quaternion.identity, k_Step, 0.1f, k_Jump, k_Turn);
                worst = k < 60 ? 0f : math.max(worst, (sampler.Velocity - Vector3.forward).magnitude);
            }

            Assert.That(worst, Is.LessThan(0.05f));
        }

        // Far away a velocity is taken over as many steps as make a motion of the finest speed four roundings of the place.
        [TestCase(1000f, 4.84e-3f, 10)]
        [TestCase(1000f, 5.3e-3f, 10)]
        [TestCase(1000f, 2.45e-3f, 20)]
        public void FarAway_AVelocityIsThatOverSeveralSteps(float place, float finest, int steps)
        {
            MotionSampler sampler = default;
            for (int k = 0; k <= steps; k++)
            {
                Assert.That(sampler.Velocity, Is.EqualTo(Vector3.zero), $"step {k}");
                sampler.Sample(new Vector3(0f, k, place), Quaternion.identity, 0.01f, finest, 1e6f, k_Turn);
            }

            Assert.That(sampler.Velocity.y, Is.EqualTo(100f).Within(0.1f));
        }

        // Half a second at most, however coarse the places are: 32 steps of a 64th.
        [Test]
        public void AVelocity_IsThatOfHalfASecond_WhereverItIs([Values(0, 1, 2)] int axis, [Values(1e6f, -1e6f)] float place)
        {
            MotionSampler sampler = default;
            for (int k = 0; k <= 32; k++)
            {
                Assert.That(sampler.Velocity, Is.EqualTo(Vector3.zero), $"step {k}");
                Vector3 at = default;
                at[axis] = place;
                at[(axis + 1) % 3] = k;
                sampler.Sample(at, Quaternion.identity, 1f / 64f, 1e-3f, 1e6f, k_Turn);
            }

            Assert.That(sampler.Velocity[(axis + 1) % 3], Is.EqualTo(64f).Within(1e-3f));
        }

        private static bool Sample(ref MotionSampler sampler, int step, bool negated)
        {
            Quaternion rotation = Rotation(step);
            if (negated)
                rotation = new Quaternion(-rotation.x, -rotation.y, -rotation.z, -rotation.w);
            return sampler.Sample(step * k_Step * s_Velocity, rotation, k_Step, k_Finest, k_Jump, k_Turn);
        }

        private static Quaternion Rotation(int step) => Quaternion.AngleAxis(step * k_Step * s_Rate.magnitude * Mathf.Rad2Deg, s_Rate);
    }
}
