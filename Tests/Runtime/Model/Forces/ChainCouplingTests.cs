using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>
    /// Effect of a strip of membrane between two chains on their bends: five parallel chains, an eighth of a wing length apart.
    /// </summary>
    public sealed unsafe class ChainCouplingTests
    {
        private const int k_Chains = 5, k_Bones = 4;
        private const float k_Width = 0.125f, k_FreeSlope = 0.1f;

        private PackFixture m_Fixture;
        private Unity.Mathematics.Random m_Random;

        [SetUp]
        public void SetUp()
        {
            WingParameters parameters = Monarch.Parameters;
            parameters.jointLimit = 1.5f;
            m_Fixture = new PackFixture(TestWings.Bake(TestWings.Lattice(), TestWings.Rectangle(), 64), parameters);
            m_Random = new Unity.Mathematics.Random(17);
            for (int bone = 0; bone < k_Chains * k_Bones; bone++)
            {
                m_Fixture.scratch.compliances[bone] =
                    Lanes.All(m_Random.NextFloat(2f, 4f), m_Random.NextFloat(0.1f, 0.2f), 1f) * (1f / m_Fixture.Pack.bendStiffness[0]);
            }
        }

        [TearDown]
        public void TearDown() => m_Fixture.Dispose();

        [Test]
        public void ChainsThatBendAlike_KeepTheirBends()
        {
            Bend((chain, bone) => new float3(0.3f - 0.2f * bone, 0.1f * bone, 0.05f * bone));
            float3[] before = Angles();
            Couple();

            for (int bone = 0; bone < before.Length; bone++)
                Assert.That(math.distance(Angles()[bone], before[bone]), Is.LessThan(1e-6f), $"bone {bone}");
        }

        [Test]
        public void ASmallDifference_IsLeftToTheSprings()
        {
            // At the tip the strip's slope is the sum of differences times (distance over width).
            float unit = 0.9f * k_FreeSlope * k_Width / (1f + 0.75f + 0.5f + 0.25f);
            Bend((chain, bone) => new float3(chain % 2 * unit, 0f, 0f));
            float3[] before = Angles();
            Couple();

            for (int bone = 0; bone < before.Length; bone++)
                Assert.That(math.distance(Angles()[bone], before[bone]), Is.LessThan(1e-7f), $"bone {bone}");
        }

        [Test]
        public void ChainsThatBendApart_AreBroughtTogether()
        {
            Bend((chain, bone) => new float3(chain % 2 == 0 ? 0.2f : -0.2f, 0f, 0f));
            float before = SteepestSlope(0);
            Couple();

            Assert.That(before, Is.GreaterThan(5f));
            Assert.That(SteepestSlope(0), Is.LessThan(0.2f * before));
        }

        [Test]
        public void AStripsForce_ActsOnBothChainsOppositely_OutOfPlaneAndInPlane()
        {
            // Parallel chains: what a strip does to a hinge of one chain, it does to the hinge beside it the other way. So the torques of a
            // row of hinges cancel.
            BendAtRandom(0.3f);
            float3[] before = Angles();
            Couple();
            float3[] after = Angles();

            for (int axis = 0; axis < 2; axis++)
            {
                double largest = 0.0;
                for (int row = 0; row < k_Bones; row++)
                {
                    double sum = 0.0, sumOfSizes = 0.0;
                    for (int chain = 0; chain < k_Chains; chain++)
                    {
                        int bone = chain * k_Bones + row;
                        double torque = (after[bone][axis] - before[bone][axis]) / (double)m_Fixture.scratch.compliances[bone][0][axis];
                        sum += torque;
                        sumOfSizes += Math.Abs(torque);
                    }

                    Assert.That(sum, Is.EqualTo(0.0).Within(1e-4 * sumOfSizes), $"axis {axis}, row {row}");
                    largest = Math.Max(largest, sumOfSizes);
                }

                Assert.That(largest, Is.GreaterThan(0.1 * m_Fixture.Pack.bendStiffness[0].x), "strips pull at all");
            }
        }

        [Test]
        public void Rates_ChangeByWhatTheAnglesChange()
        {
            const float dt = 4e-3f;
            BendAtRandom(0.3f);
            float3[] before = Angles();
            ImplicitStep step = Couple(dt);

            for (int bone = 0; bone < before.Length; bone++)
            {
                float3 wanted = (Angles()[bone] - before[bone]) / step.length.x;
                Assert.That(math.distance(m_Fixture.Pack.bendRates[bone][0], wanted), Is.LessThan(1e-4f * (1f + math.length(wanted))),
                    $"bone {bone}");
            }
        }

        [Test]
        public void AStifferWing_IsLeftWithLessSlope()
        {
            float last = float.MaxValue;
            foreach (float factor in new[] { 0.1f, 1f, 10f })
            {
                for (int bone = 0; bone < k_Chains * k_Bones; bone++)
                    m_Fixture.Pack.bendStiffness[bone] = factor;
                for (int bone = 0; bone < k_Chains * k_Bones; bone++)
                    m_Fixture.scratch.compliances[bone] = Lanes.All(0.01f, 0.01f, 0.01f);
                m_Random = new Unity.Mathematics.Random(5);
                BendAtRandom(0.2f);
                Couple();
                float slope = SteepestSlope(0);

                Assert.That(slope, Is.LessThan(last), $"stiffness {factor}");
                last = slope;
            }
        }

        [Test]
        public void NoJoint_LeavesItsLimit()
        {
            m_Fixture.Pack.parameters->numbers.jointLimit = 0.25f;
            BendAtRandom(0.25f);
            Couple();

            foreach (float3 angles in Angles())
                Assert.That(math.cmax(math.abs(angles.xy)), Is.LessThanOrEqualTo(0.25f));
        }

        [Test]
        public void Torsion_IsNoBusinessOfAStrip()
        {
            BendAtRandom(0.3f);
            float3[] before = Angles();
            Couple();

            for (int bone = 0; bone < before.Length; bone++)
                Assert.That(Angles()[bone].z, Is.EqualTo(before[bone].z));
        }

        [Test]
        public void AWing_IsCoupledTheSame_WhateverItsNeighboursInThePackDo()
        {
            // The first wing bends apart mildly, its neighbours hardly or wildly.
            float3[] Mild(float others)
            {
                m_Random = new Unity.Mathematics.Random(3);
                for (int bone = 0; bone < k_Chains * k_Bones; bone++)
                {
                    float3 mild = m_Random.NextFloat3(-0.02f, 0.02f), wild = m_Random.NextFloat3(-1f, 1f) * others;
                    var angles = new SoaFloat3(wild);
                    angles[0] = mild;
                    m_Fixture.Pack.bendAngles[bone] = angles;
                    m_Fixture.Pack.bendRates[bone] = default;
                }

                Couple();
                return Angles();
            }

            float3[] calm = Mild(0f), gale = Mild(0.5f);
            for (int bone = 0; bone < calm.Length; bone++)
                Assert.That(gale[bone], Is.EqualTo(calm[bone]), $"bone {bone}");
        }

        private void Bend(Func<int, int, float3> angles)
        {
            for (int bone = 0; bone < k_Chains * k_Bones; bone++)
            {
                m_Fixture.Pack.bendAngles[bone] = new SoaFloat3(angles(bone / k_Bones, bone % k_Bones));
                m_Fixture.Pack.bendRates[bone] = default;
            }
        }

        private void BendAtRandom(float most) => Bend((chain, bone) => m_Random.NextFloat3(-most, most));

        private ImplicitStep Couple(float dt = 4e-3f)
        {
            var step = new ImplicitStep { dt = dt, length = dt * 2f / 3f, now = 4f / 3f, before = 1f / 3f, ratio = 1f };
            ChainCoupling.Apply(m_Fixture.Pack, m_Fixture.scratch, step);
            return step;
        }

        private float3[] Angles()
        {
            var angles = new float3[k_Chains * k_Bones];
            for (int bone = 0; bone < angles.Length; bone++)
                angles[bone] = m_Fixture.Pack.bendAngles[bone][0];
            return angles;
        }

        // Of all strips, from the heights of neighbouring joints by the bends of their chains.
        private float SteepestSlope(int axis)
        {
            float3[] angles = Angles();
            float steepest = 0f;
            for (int chain = 0; chain + 1 < k_Chains; chain++)
            {
                for (int joint = 1; joint <= k_Bones; joint++)
                {
                    float height = 0f;
                    for (int bone = 0; bone < joint; bone++)
                    {
                        height +=
                            0.25f * (joint - bone) * (angles[chain * k_Bones + bone][axis] - angles[(chain + 1) * k_Bones + bone][axis]);
                    }
                    steepest = math.max(steepest, math.abs(height) / k_Width);
                }
            }

            return steepest;
        }
    }
}
