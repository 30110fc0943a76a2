using System;
using NUnit.Framework;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Dual-quaternion skinning against the textbook's per-vertex form in double precision.</summary>
    public sealed unsafe class SkinningAgainstDoubleTests
    {
        [Test]
        public void SkinnedVertices_AreTheReferences_OverRandomPoses_AllSigns()
        {
            WingRig rig = Monarch.Rig();
            var random = new Random(20241);
            var vertices = (SkinnedVertex*)UnsafeUtility.Malloc(rig.VertexCount * sizeof(SkinnedVertex), 64, Allocator.Persistent);
            var palette = new DualQuaternion[rig.JointCount];
            var target = new SkinTarget { rig = rig.View, frame = rig.Frame, vertices = vertices };
            int checkedVertices = 0;
            double worst = 0.0;
            while (checkedVertices < 100000)
            {
                quaternion common = random.NextQuaternionRotation();
                for (int joint = 0; joint < palette.Length; joint++)
                {
                    // Turned by up to 50° from each other, with either sign of the quaternion.
                    var own = quaternion.AxisAngle(random.NextFloat3Direction(), random.NextFloat(0f, math.radians(50f)));
                    palette[joint] = new DualQuaternion(math.mul(common, own), random.NextFloat3(-0.3f, 0.3f));
                    if (random.NextBool())
                        palette[joint] = new DualQuaternion { real = -palette[joint].real, dual = -palette[joint].dual };
                }

                fixed (DualQuaternion* p = palette)
                    SkinWingsJob.SkinQuads(target, p, 0, rig.View.quadCount, true);
                for (int v = 0; v < rig.VertexCount; v++)
                    worst = Math.Max(worst, Difference(rig, palette, vertices, v));
                checkedVertices += rig.VertexCount;
            }

            UnsafeUtility.Free(vertices, Allocator.Persistent);
            float length = rig.Frame.length;
            rig.Release();
            Assert.That(worst, Is.LessThan(1e-5 * length));
        }

        private static double Difference(WingRig rig, DualQuaternion[] palette, SkinnedVertex* vertices, int v)
        {
            FindRest(rig, v, out float3 position, out float3 normal);
            int4 joints = rig.VertexJoints[v];
            float4 weights = rig.VertexWeights[v];
            int heaviest = 0;
            for (int k = 1; k < 4; k++)
                heaviest = weights[k] > weights[heaviest] ? k : heaviest;
            double[] real = new double[4];
            double[] dual = new double[4];
            for (int k = 0; k < 4; k++)
            {
                DualQuaternion d = palette[joints[k]];
                double sign = Dot(d.real, palette[joints[heaviest]].real) < 0.0 ? -1.0 : 1.0;
                for (int c = 0; c < 4; c++)
                {
                    real[c] += sign * weights[k] * (double)d.real[c];
                    dual[c] += sign * weights[k] * (double)d.dual[c];
                }
            }

            double[] moved = Transform(real, dual, position, 1.0), turned = Transform(real, dual, normal, 0.0);
            double worst = 0.0;
            for (int c = 0; c < 3; c++)
            {
                worst = Math.Max(worst, Math.Abs(moved[c] - vertices[v].position[c]));
                worst = Math.Max(worst, Math.Abs(turned[c] - vertices[v].normal[c]));
            }

            return worst;
        }

        // Normalised, then R v + t with the rotation matrix of q and t = 2 e q*.
        private static double[] Transform(double[] q, double[] e, float3 v, double translation)
        {
            double norm = Math.Sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
            double x = q[0] / norm, y = q[1] / norm, z = q[2] / norm, w = q[3] / norm;
            double ex = e[0] / norm, ey = e[1] / norm, ez = e[2] / norm, ew = e[3] / norm;
            double tx = 2.0 * (-ew * x + ex * w - ey * z + ez * y);
            double ty = 2.0 * (-ew * y + ex * z + ey * w - ez * x);
            double tz = 2.0 * (-ew * z - ex * y + ey * x + ez * w);
            return new[]
            {
                (1 - 2 * (y * y + z * z)) * v.x + 2 * (x * y - w * z) * v.y + 2 * (x * z + w * y) * v.z + translation * tx,
                2 * (x * y + w * z) * v.x + (1 - 2 * (x * x + z * z)) * v.y + 2 * (y * z - w * x) * v.z + translation * ty,
                2 * (x * z - w * y) * v.x + 2 * (y * z + w * x) * v.y + (1 - 2 * (x * x + y * y)) * v.z + translation * tz,
            };
        }

        private static void FindRest(WingRig rig, int vertex, out float3 position, out float3 normal)
        {
            for (int k = 0; k < rig.View.quadCount; k++)
            {
                SkinQuad quad = rig.View.skinQuads[k];
                for (int lane = 0; lane < 4; lane++)
                {
                    if (quad.target[lane] != vertex)
                        continue;
                    position = new float3(quad.px[lane], quad.py[lane], quad.pz[lane]);
                    normal = new float3(quad.nx[lane], quad.ny[lane], quad.nz[lane]);
                    return;
                }
            }

            throw new InvalidOperationException($"Vertex {vertex} is in no quad.");
        }

        private static double Dot(float4 a, float4 b) => (double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z + (double)a.w * b.w;
    }
}
