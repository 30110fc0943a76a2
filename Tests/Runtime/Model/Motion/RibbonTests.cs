using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>The driven pose of wings whose chains lie side by side: their membrane must bear it.</summary>
    public sealed unsafe class RibbonTests
    {
        private const int k_Chains = 5, k_Joints = 5;
        private const float k_Gap = 0.02f;

        [Test]
        public void ChainsOfARibbon_FlapAsTheLeadingOneDoes()
        {
            using (PackFixture fixture = Ribbon(MembraneCoupling.TwoWay))
            {
                Evaluate(fixture, 0f);
                for (int joint = k_Joints; joint < k_Chains * k_Joints; joint++)
                {
                    float3 position = fixture.scratch.drivenPositions[joint][0],
                        leading = Leading(fixture, fixture.rig.RestJoints[joint].x);
                    Assert.That(math.distance(position.xy, leading.xy), Is.LessThan(2e-3f),
                        $"joint {joint} at {position}, the leading chain there at {leading}");
                }
            }
        }

        [Test]
        public void WithoutCoupling_EveryChainFlapsByItsOwnJoints()
        {
            using (PackFixture fixture = Ribbon(MembraneCoupling.OneWay))
            {
                Evaluate(fixture, 0f);
                int last = k_Chains * k_Joints - 1;
                for (int j = 0; j + 1 < k_Joints; j++)
                {
                    Assert.That(fixture.scratch.angle[last - k_Joints - k_Chains + 2 + j].x.x,
                        Is.EqualTo(fixture.scratch.angle[j].x.x).Within(1e-6f));
                }
                Assert.That(math.distance(fixture.scratch.drivenPositions[last][0].xy, Leading(fixture, fixture.rig.RestJoints[last].x).xy),
                    Is.GreaterThan(0.01f));
            }
        }

        [Test]
        public void ARibbon_SweepsAsAWhole()
        {
            using (PackFixture fixture = Ribbon(MembraneCoupling.TwoWay))
            {
                Evaluate(fixture, 0.5f * math.PI);
                float whole = fixture.scratch.angle[0].y.x;
                Assert.That(math.abs(whole), Is.GreaterThan(0.05f));
                float spread = fixture.Pack.rig.spread;
                for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    Assert.That(fixture.scratch.angle[bone].y.x, Is.EqualTo(whole).Within(2f * spread * math.abs(whole)));
                Assert.That(spread, Is.LessThan(0.1f));
            }
        }

        [Test]
        public void ChainsOfAFan_FlapByTheirOwnJoints()
        {
            using (var fixture = new PackFixture(Monarch.Rig(64), Monarch.Parameters))
            {
                int bones = fixture.rig.JointsPerChain - 1;
                Assert.That(fixture.Pack.rig.spread, Is.EqualTo(1f));
                for (int bone = 0; bone < fixture.rig.BoneCount; bone++)
                    Assert.That(fixture.Pack.rig.flapShares[bone], Is.EqualTo((bone % bones) / (bones - 1f)).Within(1e-6f), $"bone {bone}");
            }
        }

        // Each chain a tenth of the wing shorter than the one before.
        private static PackFixture Ribbon(MembraneCoupling coupling)
        {
            var chains = new JointChain[k_Chains];
            for (int i = 0; i < k_Chains; i++)
            {
                chains[i] = TestWings.Chain(
                    new UnityEngine.Vector3(0f, 0f, -k_Gap * i), new UnityEngine.Vector3(1f - 0.1f * i, 0f, -k_Gap * i), k_Joints);
            }
            WingParameters parameters = Monarch.Parameters;
            parameters.amplitude = new float3(parameters.amplitude.x, 0.2f, 0f);
            parameters.chordDelay = 0f;
            parameters.spanDelay = 0f;
            parameters.options.coupling = coupling;
            return new PackFixture(
                TestWings.Bake(TestWings.Skeleton(chains), TestWings.Rectangle(12, 6, 1f, (k_Chains - 1) * k_Gap), 64), parameters);
        }

        private static void Evaluate(PackFixture fixture, float phase)
        {
            fixture.Pack.beat->phase = phase;
            fixture.Pack.beat->cycles = 5f;
            DelayedWaves.Evaluate(fixture.Pack, fixture.scratch);
            DrivenPose.Evaluate(fixture.Pack, fixture.scratch);
        }

        // The place on the leading chain that lies as far out at rest.
        private static float3 Leading(PackFixture fixture, float x)
        {
            float at = x * (k_Joints - 1);
            int joint = math.min((int)at, k_Joints - 2);
            return math.lerp(fixture.scratch.drivenPositions[joint][0], fixture.scratch.drivenPositions[joint + 1][0], at - joint);
        }
    }
}
