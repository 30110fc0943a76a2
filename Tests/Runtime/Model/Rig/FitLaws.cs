using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Meshes that fit a skeleton, from both sides of each limit.</summary>
    public sealed class FitLaws
    {
        // A lattice over the inner part of a rectangle: what lies within 0.15 of its end is near.
        [TestCase(0.34f, "is far away from its skeleton: 49 % of its area")]
        [TestCase(0.37f, "along the span the joints reach 0.37 times")]
        [TestCase(0.49f, "along the span the joints reach 0.49 times")]
        [TestCase(0.51f, null)]
        [TestCase(1.95f, null)]
        [TestCase(2.05f, "along the span the joints reach 2.05 times")]
        public void AMesh_FitsJoints_ThatReachHalfAsFar_ToTwice(float reach, string problem) =>
            AssertBaked(TestWings.Lattice(length: reach), TestWings.Rectangle(100, 6), problem);

        [TestCase(0.14f, null)]
        [TestCase(0.16f, "is far away from its skeleton: 0 % of its area")]
        [TestCase(-0.14f, null)]
        [TestCase(-0.16f, "is far away from its skeleton: 0 % of its area")]
        public void AMeshAboveItsJoints_IsNear_UpToAShareOfItsLength(float height, string problem)
        {
            SurfaceMesh surface = TestWings.Rectangle();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].y = height;
            AssertBaked(TestWings.Lattice(), surface, problem);
        }

        // Over a surface of joints at any heights; the distance in the plan and that in height make one.
        [Test]
        public void TheDistanceFromTheJoints_IsThatInPlanAndHeight(
            [Values(0, 1, 2, 3)] int cell, [Values(0.1f, 0.8f)] float u, [Values(0.3f, 0.9f)] float v, [Values(-1f, 1f)] float side)
        {
            float[,] heights = { { 0.3f, 1.2f, -0.7f }, { 2.1f, -1.6f, 0.9f }, { -2.4f, 1.7f, 3.1f } };
            WingSkeleton skeleton = TestWings.Lattice(3, 3);
            for (int chain = 0; chain < 3; chain++)
            {
                for (int joint = 0; joint < 3; joint++)
                    skeleton.Chains[chain].joints[joint].y = heights[chain, joint];
            }

            var rest = new RestSkeleton(skeleton, new WingFrame(default, float3x3.identity, 1f, false));
            int i = cell / 2, j = cell % 2;
            float height = math.lerp(
                math.lerp(heights[i, j], heights[i, j + 1], v), math.lerp(heights[i + 1, j], heights[i + 1, j + 1], v), u);
            foreach (float distance in new[] { 0f, 0.09f, 0.149f })
            {
                float most = math.sqrt(0.15f * 0.15f - distance * distance);
                Assert.DoesNotThrow(() => Check(height + 0.98f * side * most, distance));
                Assert.That(() => Check(height + 1.02f * side * most, distance), Throws.ArgumentException);
            }

            Object.DestroyImmediate(skeleton);

            void Check(float at, float distance)
            {
                float3[] corners = { new float3(0f, at, 0f), new float3(0.3f, at, 0f), new float3(0f, at, 0.3f) };
                var triangles = new SurfaceTriangles(corners, new[] { 0, 1, 2 });
                FitCheck.Run("It", rest, triangles, new[] { new CellPoint { cell = cell, u = u, v = v, distance = distance } });
            }
        }

        private static void AssertBaked(WingSkeleton skeleton, SurfaceMesh surface, string problem)
        {
            if (problem == null)
                TestWings.Bake(skeleton, surface).Release();
            else
                Assert.That(() => TestWings.Bake(skeleton, surface), Throws.ArgumentException.With.Message.Contains(problem));
            Object.DestroyImmediate(skeleton);
        }
    }
}
