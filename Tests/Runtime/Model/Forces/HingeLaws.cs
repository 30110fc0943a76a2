using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Hinges at both of their limits, and how far they yield.</summary>
    public sealed unsafe class HingeLaws
    {
        private const float k_Limit = 0.5f, k_Step = 0.004f;

        [Test]
        public void AMirroredHinge_DoesTheMirrorImage()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float angle = random.NextFloat(-0.7f, 0.7f), first = random.NextFloat(-40f, 40f), torque = random.NextFloat(-3f, 3f),
                    seen = random.NextFloat(-9f, 9f);
                float4 rate = first, mirrored = -first;
                float4 turned = Bending.Hinge(0.01f, 0.2f, 0.05f, 5f, torque, k_Limit, k_Step, seen, angle, ref rate);
                float4 back = Bending.Hinge(0.01f, 0.2f, 0.05f, 5f, -torque, k_Limit, k_Step, -seen, -angle, ref mirrored);
                Assert.That(back, Is.EqualTo(-turned), $"seed {seed}");
                Assert.That(mirrored, Is.EqualTo(-rate), $"seed {seed}");
                Assert.That(math.abs(turned.x), Is.LessThanOrEqualTo(k_Limit));
            }
        }

        [TestCase(-1f)]
        [TestCase(1f)]
        public void AtEitherLimit_OutwardRatesEnd_AndInwardOnesGoOn(float side)
        {
            float4 rate = 10f * side;
            Assert.That(Bending.Hinge(0.01f, 0f, 0f, 0f, 0f, k_Limit, k_Step, 0f, side * 0.49f, ref rate).x, Is.EqualTo(side * k_Limit));
            Assert.That(rate.x, Is.Zero);
            rate = -10f * side;
            Assert.That(Bending.Hinge(0.01f, 0f, 0f, 0f, 0f, k_Limit, k_Step, 0f, side * 0.9f, ref rate).x, Is.EqualTo(side * k_Limit),
                "from beyond it is put to its limit");
            Assert.That(rate.x, Is.EqualTo(-10f * side), "and keeps the rate that brings it back");
            rate = 10f * side;
            Assert.That(Bending.Hinge(0.01f, 0f, 0f, 0f, 0f, k_Limit, k_Step, 0f, 0f, ref rate).x,
                Is.EqualTo(side * 10f * k_Step).Within(1e-6f));
            Assert.That(rate.x, Is.EqualTo(10f * side), "within them nothing is held");
        }

        // What damps by a rate that the load has seen already gives it back: at a steady rate the air takes nothing away twice.
        [Test]
        public void AirThatTheLoadsHaveSeen_DampsOnlyTheChange()
        {
            float4 rate = 3f;
            Bending.Hinge(0.01f, 0f, 0.4f, 0f, 0f, k_Limit, k_Step, 3f, 0f, ref rate);
            Assert.That(rate.x, Is.EqualTo(3f).Within(1e-5f));
        }

        // The step is linear in the torque: the compliance is the difference of two angles over that of their torques.
        [Test]
        public void Compliances_AreHowFarATorqueTurnsAHinge([Values(false, true)] bool firstOrder, [Values(false, true)] bool addedMass,
            [Values(0, 1)] int axis)
        {
            WingParameters parameters = firstOrder ? Monarch.FirstOrder : Monarch.Parameters;
            parameters.options.addedMass = addedMass && !firstOrder;
            using var flown = new PackFixture(Monarch.Rig(32), parameters, Monarch.Flying());
            for (int k = 0; k < 30; k++)
                PackStep.Run(ref flown.Pack, flown.scratch, flown.Substep);
            WingPack pack = flown.Pack;
            StepScratch scratch = flown.scratch;
            var step = ImplicitStep.Of(pack, flown.Substep);
            int bones = pack.rig.boneCount;
            SoaFloat3[] angles = Copy(pack.bendAngles, bones), rates = Copy(pack.bendRates, bones),
                earlier = Copy(pack.earlierAngles, bones);
            SoaFloat3[] earlierRates = Copy(pack.earlierRates, bones), torques = Copy(scratch.torques, bones), found = new SoaFloat3[bones];
            float[] torque = new float[bones];
            for (int way = -1; way <= 1; way++)
            {
                for (int bone = 0; bone < bones; bone++)
                {
                    pack.bendAngles[bone] = 0.2f * angles[bone];
                    pack.bendRates[bone] = 0.1f * rates[bone];
                    pack.earlierAngles[bone] = 0.2f * earlier[bone];
                    pack.earlierRates[bone] = 0.1f * earlierRates[bone];
                    SoaQuaternion bent = firstOrder ? pack.bentRotations[bone] : scratch.turns[bone] * pack.bentRotations[bone];
                    float3 about = axis == 0 ? pack.rig.bendAxes[bone] : new float3(0f, 1f, 0f);
                    scratch.torques[bone] = 0.01f * torques[bone] + SoaQuaternion.Rotate(bent, new SoaFloat3(about)) * (way * torque[bone]);
                }

                Bending.Turn(pack, scratch, step);
                for (int bone = 0; bone < bones; bone++)
                {
                    float compliance = axis == 0 ? scratch.compliances[bone].x.x : scratch.compliances[bone].y.x;
                    float angle = axis == 0 ? pack.bendAngles[bone].x.x : pack.bendAngles[bone].y.x;
                    if (way == 1)
                        Assert.That(angle - found[bone].x.x, Is.EqualTo(0.02f).Within(2e-4f), $"bone {bone}");
                    // The first pass finds the torque that turns a hinge by 0.02 rad, the second one where it is without, the third one
                    // where it is with it.
                    torque[bone] = way == -1 ? 0.02f / compliance : torque[bone];
                    found[bone].x = angle;
                }
            }
        }

        private static SoaFloat3[] Copy(SoaFloat3* from, int count)
        {
            var copy = new SoaFloat3[count];
            for (int k = 0; k < count; k++)
                copy[k] = from[k];
            return copy;
        }
    }
}
