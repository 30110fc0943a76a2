using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class DualQuaternionTests
    {
        [Test]
        public void Blend_OfTwoTransforms_MovesThePointWhereItShould()
        {
            var a = new DualQuaternion(quaternion.RotateZ(math.radians(40f)), new float3(1f, 0f, 0f));
            var b = new DualQuaternion(quaternion.RotateX(math.radians(-20f)), new float3(0f, 0.5f, 0.2f));
            foreach (float sign in new[] { 1f, -1f })
            {
                var turned = new DualQuaternion { real = sign * b.real, dual = sign * b.dual };
                CellBlend blend = default;
                blend.Set(a, turned, a, turned);
                AssertPoint(blend, 0.7f);
            }
        }

        [Test]
        public void Swing_IsTheShortestTurn()
        {
            var swing = SoaQuaternion.Swing(
                Lanes.All(1f, 0f, 0f), new SoaFloat3(math.normalize(new float3(1f, 0.4f, -0.2f))), new SoaQuaternion(default, 1f));
            float4 q = swing[0].value;

            // About the normal of both directions, by half of the angle between them.
            double across = Math.Sqrt(0.4 * 0.4 + 0.2 * 0.2), degrees = Math.Atan2(across, 1.0) * 180.0 / Math.PI;
            var expected = Rotation.About(0.0, 0.2 / across, 0.4 / across, degrees);
            Assert.That(q.w, Is.EqualTo(expected.w).Within(Lanes.CheckTolerance));
            Assert.That(q.x, Is.Zero.Within(Lanes.CheckTolerance));
            Assert.That(q.y, Is.EqualTo(expected.y).Within(Lanes.CheckTolerance));
            Assert.That(q.z, Is.EqualTo(expected.z).Within(Lanes.CheckTolerance));
        }

        // The vertices still hold another place, from which the way leads; without a last picture there is none.
        [Test]
        public unsafe void TheWay_LeadsFromTheLastPlace([Values] bool packed, [Values] bool displaces)
        {
            var a = new DualQuaternion(quaternion.RotateZ(math.radians(40f)), new float3(1f, 0f, 0f));
            CellBlend blend = default;
            blend.Set(a, a, a, a);
            var quad = new SkinQuad
            {
                u = 0.4f,
                v = 0.2f,
                px = new float4(0.3f, 0.1f, -0.5f, 0.7f),
                py = 0.4f,
                pz = 0.5f,
                ny = 1f,
                target = new int4(2, 0, 3, 1),
            };
            SkinnedVertex* vertices = stackalloc SkinnedVertex[5];
            PackedVertex* packedVertices = stackalloc PackedVertex[4];
            VertexDisplacement* ways = stackalloc VertexDisplacement[4];
            var last = new float3[4];
            for (int vertex = 0; vertex < 4; vertex++)
            {
                last[vertex] = new float3(0.1f * vertex, 0.7f - vertex, 0.25f);
                vertices[vertex].position = packedVertices[vertex].position = last[vertex];
                ways[vertex] = new VertexDisplacement { xy = uint.MaxValue, z = uint.MaxValue };
            }

            var target = new SkinTarget { displaces = displaces, displacements = ways };
            if (packed)
                target.packedVertices = packedVertices;
            else
                target.vertices = vertices;
            target.rig.skinQuads = &quad;
            SoaBounds bounds = SoaBounds.Empty;
            DualQuaternionSkinning.Cell(&blend, null, target, 0, 1, &bounds);

            for (int vertex = 0; vertex < 4; vertex++)
            {
                float3 now = packed ? packedVertices[vertex].position : vertices[vertex].position;
                float3 wanted = displaces ? now - last[vertex] : default;
                var way = new float3(
                    math.f16tof32(ways[vertex].xy & 0xFFFF), math.f16tof32(ways[vertex].xy >> 16),
                    math.f16tof32(ways[vertex].z & 0xFFFF));
                Assert.That(math.distance(way, wanted), Is.LessThan(1e-3f), $"vertex {vertex}");
                Assert.That(ways[vertex].z >> 16, Is.Zero);
            }
        }

        private static unsafe void AssertPoint(CellBlend blend, float v)
        {
            var quad =
                new SkinQuad { u = 0.4f, v = v, px = 0.3f, py = 0.4f, pz = 0.5f, nx = 0f, ny = 1f, nz = 0f, target = new int4(0, 1, 2, 3) };
            SkinnedVertex* vertices = stackalloc SkinnedVertex[5];
            var target = new SkinTarget { vertices = vertices };
            target.rig.skinQuads = &quad;
            SoaBounds bounds = SoaBounds.Empty;
            DualQuaternionSkinning.Cell(&blend, null, target, 0, 1, &bounds);
            Rotation expected = Blended(v);
            for (int lane = 0; lane < 4; lane++)
            {
                Assert.That(vertices[lane].position.x, Is.EqualTo(expected.x).Within(Lanes.CheckTolerance));
                Assert.That(vertices[lane].position.y, Is.EqualTo(expected.y).Within(Lanes.CheckTolerance));
                Assert.That(vertices[lane].position.z, Is.EqualTo(expected.z).Within(Lanes.CheckTolerance));
                Assert.That(bounds.max.x[lane], Is.EqualTo(vertices[lane].position.x));
            }
        }

        // Kavan and others (2007): real and dual parts are blended and divided by the length of the real one; a dual part is half of
        // translation times rotation.
        private static Rotation Blended(double v)
        {
            Rotation first = Rotation.About(0, 0, 1, 40), second = Rotation.About(1, 0, 0, -20);
            Rotation real = (1.0 - v) * first + v * second;
            Rotation dual = (0.5 * (1.0 - v)) * (Rotation.Vector(1, 0, 0) * first) + (0.5 * v) * (Rotation.Vector(0, 0.5, 0.2) * second);
            real = 1.0 / real.Length * real;
            dual = 1.0 / ((1.0 - v) * first + v * second).Length * dual;
            return real * Rotation.Vector(0.3, 0.4, 0.5) * real.Back + 2.0 * (dual * real.Back);
        }
    }
}
