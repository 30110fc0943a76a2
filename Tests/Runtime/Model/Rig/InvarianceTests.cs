using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Equality of the rigs of one wing in other units, places and poses, and as its mirror image.</summary>
    public sealed unsafe class InvarianceTests : RigFixture
    {
        [Test]
        public void UnitsDoNotMatter([Values(1e-3f, 0.061f, 100f)] float scale)
        {
            WingRig rig = Moved(p => p * scale, d => d);

            Assert.That(rig.Frame.length, Is.EqualTo(scale).Within(1e-6f * scale));
            AssertSameRig(rig, Bake());
        }

        [Test]
        public void PlaceAndDirectionDoNotMatter()
        {
            quaternion turn = math.normalize(new quaternion(0.3f, -0.5f, 0.2f, 0.7f));
            var away = new float3(0.4f, -1.5f, 2f);
            WingRig rig = Moved(p => math.rotate(turn, p) + away, d => math.rotate(turn, d));

            Assert.That(rig.Frame.mirrored, Is.False);
            AssertSameRig(rig, Bake());
        }

        [Test]
        public void ALeftWing_IsComputedAsTheRightOne()
        {
            WingRig rig = Moved(p => new float3(-p.x, p.y, p.z), d => new float3(-d.x, d.y, d.z));

            Assert.That(rig.Frame.mirrored, Is.True);
            Assert.That(Bake().Frame.mirrored, Is.False);
            Assert.That(math.distance(rig.Frame.ToWing(new float3(-0.5f, 0.1f, 0.2f)), new float3(0.5f, 0.1f, 0.2f)), Is.LessThan(1e-6f));
            AssertSameRig(rig, Bake());
        }

        [Test]
        public void TheFrame_LeadsThereAndBack()
        {
            quaternion turn = math.normalize(new quaternion(0.3f, -0.5f, 0.2f, 0.7f));
            foreach (float side in new[] { 1f, -1f })
            {
                float3 Direction(float3 d) => math.rotate(turn, new float3(side * d.x, d.y, d.z));
                WingFrame frame = Moved(p => 0.3f * Direction(p), Direction).Frame;
                var point = new float3(0.2f, -0.3f, 0.7f);

                Assert.That(frame.mirrored, Is.EqualTo(side < 0f));
                Assert.That(math.distance(frame.ToMesh(frame.ToWing(point)), point), Is.LessThan(1e-6f));
                Assert.That(math.distance(frame.DirectionToMesh(frame.DirectionToWing(point)), point), Is.LessThan(1e-6f));
                Assert.That(math.length(frame.DirectionToWing(point)), Is.EqualTo(math.length(point)).Within(1e-6f));
                Assert.That(math.distance(frame.ToWing(frame.origin), float3.zero), Is.EqualTo(0f));
            }
        }

        [Test]
        public void Baking_GivesTheSameBitsEveryTime()
        {
            WingRig a = Bake(64), b = Bake(64);

            Assert.That(Bytes(a), Is.EqualTo(Bytes(b)));
        }

        [Test]
        public void TheHinge_IsTheOrigin()
        {
            WingSkeleton skeleton = TestWings.Fan();
            skeleton.Hinge = new Vector3(-0.1f, 0f, 0f);
            WingRig rig = Bake(skeleton, TestWings.Ellipse());

            Assert.That(rig.Frame.length, Is.EqualTo(1.1f).Within(1e-6f));
            Assert.That(rig.RestJoints[0].x, Is.EqualTo(0.1f / 1.1f).Within(1e-6f));
        }

        private WingRig Moved(Func<float3, float3> point, Func<float3, float3> direction)
        {
            WingSkeleton skeleton = TestWings.Fan();
            SurfaceMesh surface = TestWings.Ellipse();
            surface.positions = surface.positions.Select(p => (Vector3)point(p)).ToArray();
            surface.normals = surface.normals.Select(n => (Vector3)direction(n)).ToArray();
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j] = point(chain.joints[j]);
            }

            skeleton.Hinge = point(skeleton.Hinge);
            skeleton.SpanAxis = direction(skeleton.SpanAxis);
            skeleton.UpAxis = direction(skeleton.UpAxis);
            return Bake(skeleton, surface);
        }

        private static void AssertSameRig(WingRig rig, WingRig expected)
        {
            const float k_Near = 2e-5f;
            RigView a = rig.View, b = expected.View;
            Assert.That(a.patchCount, Is.EqualTo(b.patchCount));
            Assert.That(rig.Area, Is.EqualTo(expected.Area).Within(k_Near));
            AssertNear((float*)a.restJoints, (float*)b.restJoints, 3 * b.jointCount, k_Near, "rest joints");
            AssertNear((float*)a.bendAxes, (float*)b.bendAxes, 3 * b.boneCount, k_Near, "bend axes");
            AssertNear((float*)a.crossDirections, (float*)b.crossDirections, 3 * b.boneCount, k_Near, "cross directions");
            AssertNear(a.jointMasses, b.jointMasses, b.jointCount, k_Near, "masses");
            AssertNear(a.jointInertias, b.jointInertias, b.boneCount, k_Near, "inertias");
            AssertNear(a.patchU, b.patchU, b.patchCount, 1e-3f, "patch u");
            AssertNear(a.patchV, b.patchV, b.patchCount, 1e-3f, "patch v");
            AssertNear(a.patchSpan, b.patchSpan, b.patchCount, 1e-4f, "patch span");
            AssertNear(a.patchChord, b.patchChord, b.patchCount, 1e-4f, "patch chord");
        }

        private static void AssertNear(float* actual, float* expected, int count, float tolerance, string what)
        {
            for (int k = 0; k < count; k++)
                Assert.That(actual[k], Is.EqualTo(expected[k]).Within(tolerance), $"{what} {k}");
        }

        private static byte[] Bytes(WingRig rig)
        {
            RigView view = rig.View;
            byte[] patches = Copy(view.patchU, view.patchCount * sizeof(float));
            byte[] areas = Copy(view.patchAreas, view.patchCount * sizeof(float));
            byte[] quads = Copy(view.skinQuads, view.quadCount * sizeof(SkinQuad));
            byte[] masses = Copy(view.jointMasses, view.jointCount * sizeof(float));
            return patches.Concat(areas).Concat(quads).Concat(masses).ToArray();
        }

        private static byte[] Copy(void* from, int bytes)
        {
            byte[] copy = new byte[bytes];
            for (int k = 0; k < bytes; k++)
                copy[k] = ((byte*)from)[k];
            return copy;
        }
    }
}
