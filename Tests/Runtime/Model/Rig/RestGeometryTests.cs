using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class RestGeometryTests : RigFixture
    {
        [Test]
        public void Ratios_GrowFromLeadingToTrailingRootAndFromRootToTip()
        {
            WingRig rig = Bake();
            for (int k = 0; k < 5; k++)
            {
                Assert.That(rig.View.chainRatio[k], Is.EqualTo(0.25f * k).Within(1e-6f));
                Assert.That(rig.View.jointRatio[k], Is.EqualTo(0.25f * k).Within(1e-6f));
            }
        }

        [Test]
        public void ChainsFromOneRoot_CountEvenly()
        {
            WingSkeleton skeleton = TestWings.Fan();
            for (int i = 1; i < 5; i++)
                skeleton.Chains[i].joints[0] = skeleton.GetJoint(0, 0);
            WingRig rig = Bake(skeleton, TestWings.Ellipse());

            for (int i = 0; i < 5; i++)
                Assert.That(rig.View.chainRatio[i], Is.EqualTo(0.25f * i));
            foreach (float4 weights in rig.VertexWeights.ToArray())
                Assert.That(math.all(math.isfinite(weights)), Is.True);
        }

        [Test]
        public void BendAxes_TurnTheTipUp()
        {
            WingRig rig = Bake();
            for (int bone = 0; bone < rig.BoneCount; bone++)
            {
                float3 t = rig.View.boneDirections[bone], b = rig.View.bendAxes[bone];
                int inner = bone / 4 * 5 + bone % 4;
                Assert.That(math.distance(rig.View.bones[bone], rig.RestJoints[inner + 1] - rig.RestJoints[inner]), Is.LessThan(1e-7f));
                Assert.That(math.distance(math.normalize(rig.View.bones[bone]), t), Is.LessThan(1e-6f));
                Assert.That(math.rotate(quaternion.AxisAngle(b, 0.1f), t).y, Is.GreaterThan(0.09f));
                Assert.That(math.dot(t, b), Is.EqualTo(0f).Within(1e-6f));
                Assert.That(math.length(b), Is.EqualTo(1f).Within(1e-6f));
            }
        }

        [Test]
        public void CrossDirections_RunFromTheChainBeforeToTheChainAfter()
        {
            WingRig rig = Bake(TestWings.Lattice(), TestWings.Rectangle());
            for (int bone = 0; bone < rig.BoneCount; bone++)
            {
                bool oneSided = bone < 4 || bone >= 16;
                var expected = new float3(0f, 0f, oneSided ? -0.125f : -0.25f);
                Assert.That(math.distance(rig.View.crossDirections[bone], expected), Is.LessThan(1e-6f), $"bone {bone}");
            }
        }

        [Test]
        public void TheLeadingEdge_PointsFromRootToTipOfThePrincipalChain()
        {
            Assert.That(math.distance(Bake().View.leadingEdge, new float3(1f, 0f, 0f)), Is.LessThan(1e-6f));
        }

        [Test]
        public void Counts_FollowFromChainsAndJoints()
        {
            WingRig rig = Bake(TestWings.Fan(6, 4), TestWings.Ellipse());

            Assert.That(rig.ChainCount, Is.EqualTo(6));
            Assert.That(rig.JointsPerChain, Is.EqualTo(4));
            Assert.That(rig.JointCount, Is.EqualTo(24));
            Assert.That(rig.BoneCount, Is.EqualTo(18));
            Assert.That(rig.CellCount, Is.EqualTo(15));
        }
    }
}
