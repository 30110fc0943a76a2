using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class ElasticStepTests
    {
        [Test]
        public void Retention_OfTheRate_IsThatOfADampedAnchor()
        {
            float anchorRate = 2f * 2f * math.PI * 11f;
            double expected = Math.Exp(-2.0 * 0.3 * 44.0 * Math.PI / 240.0);
            Assert.That(ElasticStep.Retention(0.3f, anchorRate, 1f / 240f).x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        // Without springs a joint swings about its anchor: ë + 2ζΩ ė + Ω² e = 0, e = e^(−ζΩt) (cos ωt + ζΩ/ω sin ωt), ω² = Ω² (1 − ζ²).
        [Test]
        public void AJointWithoutSprings_SwingsAsADampedAnchorDoes([Values(0f, 0.3f)] float damping)
        {
            float coarse = Error(damping, 100), fine = Error(damping, 200);

            Assert.That(fine, Is.LessThan(0.02f));
            Assert.That(coarse / fine, Is.InRange(3f, 5f), "of second order");
        }

        // The driven motion turns deviations along.
        [Test]
        public void ATurnOfTheDrivenMotion_TurnsTheSwing()
        {
            using PackFixture pack = Swinging(0.1f), turned = Swinging(0.1f);
            float3 axis = math.normalize(new float3(1f, -2f, 3f));
            const float turn = 0.05f;
            for (int k = 1; k <= 30; k++)
            {
                Step(pack, 1e-3f, quaternion.identity);
                Step(turned, 1e-3f, quaternion.AxisAngle(axis, turn));
                float3 expected = math.rotate(quaternion.AxisAngle(axis, k * turn), pack.Pack.offsets[7][1]);
                Assert.That(math.distance(turned.Pack.offsets[7][1], expected), Is.LessThan(1e-4f), $"step {k}");
            }
        }

        // Largest error over a swing and a half, from rest at (1, 0, −2).
        private static float Error(float damping, int steps)
        {
            using PackFixture pack = Swinging(damping);
            double rate = pack.Pack.parameters->anchorRate[1], swing = rate * Math.Sqrt(1.0 - damping * damping), fade = damping * rate;
            float dt = (float)(3.0 * Math.PI / rate / steps);
            double worst = 0.0;
            for (int k = 1; k <= steps; k++)
            {
                Step(pack, dt, quaternion.identity);
                double t = k * (double)dt, expected = Math.Exp(-fade * t) * (Math.Cos(swing * t) + fade / swing * Math.Sin(swing * t));
                float3 offset = pack.Pack.offsets[7][1];
                worst = Math.Max(worst, math.distance(offset, (float)expected * new float3(1f, 0f, -2f)));
            }

            return (float)worst;
        }

        private static PackFixture Swinging(float damping)
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.springScale = 0f;
            parameters.springDamping = damping;
            var pack = new PackFixture(TestWings.Rig(16), parameters);
            for (int joint = 0; joint < pack.rig.JointCount; joint++)
            {
                pack.Pack.offsets[joint] = pack.Pack.earlierOffsets[joint] = Lanes.All(1f, 0f, -2f);
                pack.Pack.offsetRates[joint] = pack.Pack.earlierOffsetRates[joint] = default;
                pack.scratch.targets[joint] = Lanes.All(joint, 0f, 0f);
            }

            return pack;
        }

        private static void Step(PackFixture pack, float dt, quaternion turn)
        {
            for (int bone = 0; bone < pack.rig.BoneCount; bone++)
                pack.scratch.turns[bone] = new SoaQuaternion(new SoaFloat3(turn.value.xyz), turn.value.w);
            ElasticStep.Step(pack.Pack, pack.scratch, ImplicitStep.Of(pack.Pack, dt));
            *pack.Pack.lastSubstep = dt;
        }
    }
}
