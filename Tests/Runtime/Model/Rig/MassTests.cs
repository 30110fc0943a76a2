using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class MassTests : RigFixture
    {
        [TestCase(3, 3)]
        [TestCase(5, 5)]
        [TestCase(8, 7)]
        [TestCase(16, 16)]
        public void JointMasses_SumToOne_AndNoneVanishes(int chains, int joints)
        {
            WingRig rig = Bake(TestWings.Fan(chains, joints), TestWings.Ellipse());

            Assert.That(rig.JointMasses.ToArray().Sum(m => (double)m), Is.EqualTo(1.0).Within(1e-6));
            Assert.That(rig.JointMasses.ToArray().Min(), Is.GreaterThan(0.9e-4f));
        }

        [Test]
        public void JointMasses_HaveTheirCentreWhereTheAreaHasIt()
        {
            SurfaceMesh surface = TestWings.Rectangle();
            WingRig rig = Bake(TestWings.Lattice(), surface);

            float3 centre = default;
            for (int joint = 0; joint < rig.JointCount; joint++)
                centre += rig.JointMasses[joint] * rig.RestJoints[joint];
            Assert.That(math.distance(centre, new float3(0.5f, 0f, -0.25f)), Is.LessThan(1e-5f));
        }

        [Test]
        public void OnARegularLattice_AnInnerJointCarriesOneCellsShare()
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Rectangle(64, 64));

            // 16 equal cells, each a quarter to each of its joints.
            Assert.That(rig.JointMasses[2 * 5 + 2], Is.EqualTo(1f / 16f).Within(1e-4f));
            Assert.That(rig.JointMasses[2], Is.EqualTo(1f / 32f).Within(1e-4f));
            Assert.That(rig.JointMasses[0], Is.EqualTo(1f / 64f).Within(1e-4f));
        }

        [Test]
        public void AJointWithoutMesh_KeepsASmallMass()
        {
            WingSkeleton skeleton = TestWings.Lattice();
            for (int i = 0; i < 5; i++)
                skeleton.Chains[i].joints[4].x = 1.6f;
            WingRig rig = Bake(skeleton, TestWings.Rectangle(8, 4, 0.95f));
            float least = rig.JointMasses.ToArray().Min();

            Assert.That(least, Is.GreaterThan(0.9e-4f));
            Assert.That(rig.JointMasses.ToArray().Sum(), Is.EqualTo(1f).Within(1e-5f));
        }

        [Test]
        public void Inertias_AreThoseOfTheJointsBeyond()
        {
            WingRig rig = Bake();
            for (int bone = 0; bone < rig.BoneCount; bone++)
            {
                int chain = bone / 4, joint = bone % 4;
                double expected = 0.0;
                for (int k = joint + 1; k < 5; k++)
                    expected += rig.JointMasses[chain * 5 + k] * Math.Pow(Distance(rig, chain, k, joint), 2.0);
                Assert.That(rig.View.jointInertias[bone], Is.EqualTo(expected).Within(1e-6 * expected), $"bone {bone}");
                Assert.That(rig.View.jointInertias[bone], Is.GreaterThan(0f));
            }
        }

        [Test]
        public void LeverDamping_IsTheLeverTimesTheSumOfLevers()
        {
            WingRig rig = Bake();
            for (int chain = 0; chain < 5; chain++)
            {
                for (int joint = 0; joint < 5; joint++)
                {
                    for (int k = 0; k < 5; k++)
                    {
                        double levers = 0.0;
                        for (int l = 0; l < k; l++)
                            levers += Distance(rig, chain, k, l);
                        double expected = k > joint ? Distance(rig, chain, k, joint) * levers : 0.0;
                        Assert.That(rig.View.leverDamping[(chain * 5 + joint) * 5 + k], Is.EqualTo(expected).Within(1e-6));
                    }
                }
            }
        }

        [Test]
        public void Springs_JoinNeighboursAlongAcrossAndOver_ButNoTwoRoots()
        {
            const int n = 6, m = 4;
            WingRig rig = Bake(TestWings.Fan(n, m), TestWings.Ellipse());

            Assert.That(rig.SpringCount, Is.EqualTo(n * (m - 1) + (n - 1) * (m - 1) + 2 * (n - 1) * (m - 1)));
            Assert.That(rig.Springs.ToArray().Select(s => (s.a, s.b)).Distinct().Count(), Is.EqualTo(rig.SpringCount));
            foreach (Spring spring in rig.Springs.ToArray())
            {
                int chains = spring.b / m - spring.a / m, joints = Math.Abs(spring.b % m - spring.a % m);
                Assert.That(chains, Is.InRange(0, 1));
                Assert.That(joints, Is.InRange(0, 1));
                Assert.That(chains + joints, Is.GreaterThan(0));
                Assert.That(spring.a % m + spring.b % m, Is.GreaterThan(0), "both ends are roots");
                Assert.That(spring.a, Is.LessThan(spring.b));
                Assert.That(spring.length, Is.EqualTo(math.distance(rig.RestJoints[spring.a], rig.RestJoints[spring.b])).Within(1e-7f));
            }
        }

        private static double Distance(WingRig rig, int chain, int a, int b) =>
            math.distance(rig.RestJoints[chain * 5 + a], rig.RestJoints[chain * 5 + b]);
    }
}
