using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of every rig, over random wings: any fan, any grid, warped, turned, scaled, left or right.</summary>
    public sealed unsafe class RandomRigTests
    {
        [Test]
        public void EveryRandomWing_KeepsTheLawsOfARig()
        {
            foreach (uint seed in Seeds.Usual)
                CheckLaws(new Random(seed), $"seed {seed}");
        }

        private static void CheckLaws(Random random, string given)
        {
            (WingSkeleton skeleton, SurfaceMesh surface) = Wing(ref random);
            WingRig rig = TestWings.Bake(skeleton, surface, random.NextInt(2) * random.NextInt(400));
            try
            {
                CheckMasses(rig, given);
                CheckWeights(rig, given);
                CheckPatches(rig, given);
                CheckFrame(rig, surface, given);
            }
            finally
            {
                rig.Release();
            }
        }

        private static void CheckMasses(WingRig rig, string given)
        {
            double mass = 0.0;
            for (int joint = 0; joint < rig.JointCount; joint++)
            {
                Assert.That(rig.JointMasses[joint], Is.GreaterThan(0f), given);
                mass += rig.JointMasses[joint];
            }

            Assert.That(mass, Is.EqualTo(1.0).Within(1e-5), given);
            for (int bone = 0; bone < rig.BoneCount; bone++)
                Assert.That(rig.View.jointInertias[bone], Is.GreaterThan(0f), given);
        }

        private static void CheckWeights(WingRig rig, string given)
        {
            for (int k = 0; k < rig.VertexCount; k++)
            {
                Assert.That(math.csum(rig.VertexWeights[k]), Is.EqualTo(1f).Within(1e-6f), given);
                Assert.That(math.cmin(rig.VertexWeights[k]), Is.GreaterThanOrEqualTo(0f), given);
                Assert.That(math.cmax(rig.VertexJoints[k]), Is.LessThan(rig.JointCount), given);
            }

            int influences = rig.VertexWeights.ToArray().Sum(w => math.csum(math.select(new int4(0), new int4(1), w != 0f)));
            Assert.That(rig.JointVertices.Length, Is.EqualTo(influences), given);
        }

        private static void CheckPatches(WingRig rig, string given)
        {
            double area = 0.0;
            for (int patch = 0; patch < rig.PatchCount; patch++)
            {
                area += rig.View.patchAreas[patch];
                Assert.That(rig.View.patchU[patch], Is.InRange(0f, 1f), given);
                Assert.That(rig.View.patchV[patch], Is.InRange(0f, 1f), given);
                Assert.That(math.isfinite(rig.View.patchSpan[patch]) && math.isfinite(rig.View.patchChord[patch]), Is.True, given);
            }

            Assert.That(area, Is.EqualTo(rig.Area).Within(1e-4 * rig.Area), given);
        }

        private static void CheckFrame(WingRig rig, SurfaceMesh surface, string given)
        {
            float tip = float.MinValue;
            foreach (Vector3 position in surface.positions)
                tip = math.max(tip, rig.Frame.ToWing(position).x);
            Assert.That(tip, Is.EqualTo(1f).Within(1e-5f), given);
            Assert.That(
                rig.RestJoints[0].z, Is.GreaterThan(rig.RestJoints[rig.JointCount - 1].z), $"the leading edge lies forward, {given}");
        }

        private static (WingSkeleton, SurfaceMesh) Wing(ref Random random)
        {
            float chord = 0.2f + random.NextFloat();
            WingSkeleton skeleton = TestWings.Fan(random.NextInt(3, 9), random.NextInt(3, 9), 1f, chord);
            SurfaceMesh surface = random.NextInt(2) == 0
                ? TestWings.Ellipse(random.NextInt(4, 20), random.NextInt(2, 12), 1f, chord)
                : TestWings.Rectangle(random.NextInt(4, 20), random.NextInt(2, 12), 1f, 0.7f * chord);
            float height = 0.1f * random.NextFloat(), wave = 8f * random.NextFloat(), scale = math.exp(8f * random.NextFloat() - 6f);
            float side = random.NextInt(2) == 0 ? 1f : -1f;
            float3 axis = new float3(random.NextFloat(), random.NextFloat(), random.NextFloat()) - 0.5f;
            quaternion turn = math.normalize(new quaternion(axis.x, axis.y, axis.z, 0.1f + random.NextFloat()));

            Vector3 Turned(Vector3 d) => math.rotate(turn, new float3(side * d.x, d.y, d.z));
            Vector3 Placed(Vector3 p) => scale * (float3)Turned(new Vector3(p.x, p.y + height * math.sin(wave * p.x + p.z), p.z));
            surface.positions = surface.positions.Select(Placed).ToArray();
            surface.normals = null;
            foreach (JointChain chain in skeleton.Chains)
            {
                for (int j = 0; j < chain.Length; j++)
                    chain.joints[j] = Placed(chain.joints[j]);
            }

            skeleton.Hinge = skeleton.GetJoint(0, 0);
            skeleton.SpanAxis = Turned(skeleton.SpanAxis);
            skeleton.UpAxis = Turned(skeleton.UpAxis);
            return (skeleton, surface);
        }
    }
}
