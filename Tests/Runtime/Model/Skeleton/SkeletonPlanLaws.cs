using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Measures of a skeleton seen from above, against boxes and rectangles.</summary>
    public sealed class SkeletonPlanLaws
    {
        [TestCase(3f, 2f, 1f)]
        [TestCase(1f, 5f, 2f)]
        [TestCase(2f, 1f, 7f)]
        public void TheSize_IsTheLongestOfTheThreeExtents(float x, float y, float z)
        {
            WingSkeleton skeleton = Grid(x, y, z);
            foreach (float angle in new[] { 0f, 0.8f })
            {
                // Axes turned with the joints measure the same.
                var turn = quaternion.AxisAngle(math.normalize(new float3(1f, 2f, -1f)), angle);
                WingSkeleton turned = Grid(x, y, z);
                foreach (JointChain chain in turned.Chains)
                {
                    for (int j = 0; j < chain.joints.Length; j++)
                        chain.joints[j] = new float3(4f, 5f, 6f) + math.rotate(turn, chain.joints[j]);
                }

                turned.Hinge = turned.Chains[0].joints[0];
                var plan = new SkeletonPlan(turned, new float3x3(turn));
                Assert.That(plan.Size, Is.EqualTo(math.max(x, math.max(y, z))).Within(1e-4));
                Assert.That(plan.HeightExtent, Is.EqualTo(y).Within(1e-4));
                Assert.That((plan[0, 0].x, plan[0, 0].z), Is.EqualTo((0.0, 0.0)), "about the hinge");
                Assert.That((plan.ChainCount, plan.JointsPerChain), Is.EqualTo((3, 4)));
                Object.DestroyImmediate(turned);
            }

            Object.DestroyImmediate(skeleton);
        }

        [Test]
        public void Areas_AreThoseOfTheRectangles_WithTheSignOfTheirSide()
        {
            WingSkeleton skeleton = Grid(3f, 0f, 2f);
            float3 span = new float3(1f, 0f, 0f), up = new float3(0f, 1f, 0f);
            var axes = new float3x3(span, up, math.cross(span, up));
            var mirrored = new float3x3(axes.c0, -axes.c1, -axes.c2);
            SkeletonPlan plan = new SkeletonPlan(skeleton, axes), other = new SkeletonPlan(skeleton, mirrored);

            Assert.That(math.abs((float)plan.SignedArea()), Is.EqualTo(6f).Within(1e-4f));
            Assert.That(other.SignedArea(), Is.EqualTo(-plan.SignedArea()).Within(1e-5));
            Assert.That(plan.StripArea(0) + plan.StripArea(1), Is.EqualTo(plan.SignedArea()).Within(1e-5));
            Assert.That(plan.DistanceSquared(0, 11), Is.EqualTo(9.0 + 4.0).Within(1e-4), "from corner to corner");
            Object.DestroyImmediate(skeleton);
        }

        // Three chains of four joints over a box, from its near leading corner.
        private static WingSkeleton Grid(float x, float y, float z)
        {
            WingSkeleton skeleton = ScriptableObject.CreateInstance<WingSkeleton>();
            skeleton.Chains = new JointChain[3];
            for (int i = 0; i < 3; i++)
            {
                skeleton.Chains[i].joints = new Vector3[4];
                for (int j = 0; j < 4; j++)
                    skeleton.Chains[i].joints[j] = new Vector3(x * j / 3f, j == 2 ? y : 0f, -z * i / 2f);
            }

            skeleton.Hinge = skeleton.Chains[0].joints[0];
            return skeleton;
        }
    }
}
