using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    public sealed unsafe class SkinLayoutTests : RigFixture
    {
        [Test]
        public void EveryVertex_IsSkinnedWithItsOwnPositionNormalAndCell()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            WingRig rig = Bake(TestWings.Fan(), surface);
            int[] written = new int[rig.VertexCount];
            for (int cell = 0; cell < rig.CellCount; cell++)
            {
                SkinCell run = rig.View.skinCells[cell];
                for (int quad = run.firstQuad; quad < run.firstQuad + run.quadCount; quad++)
                {
                    for (int lane = 0; lane < 4; lane++)
                    {
                        SkinQuad q = rig.View.skinQuads[quad];
                        int vertex = q.target[lane];
                        written[vertex]++;
                        Assert.That(new Vector3(q.px[lane], q.py[lane], q.pz[lane]), Is.EqualTo(surface.positions[vertex]));
                        Assert.That(new Vector3(q.nx[lane], q.ny[lane], q.nz[lane]), Is.EqualTo(surface.normals[vertex]));
                        Assert.That(rig.VertexJoints[vertex].x, Is.EqualTo(cell / 4 * 5 + cell % 4));
                        Assert.That(rig.VertexWeights[vertex].w, Is.EqualTo(q.u[lane] * q.v[lane]));
                        Assert.That(rig.VertexWeights[vertex].x, Is.EqualTo((1f - q.u[lane]) * (1f - q.v[lane])));
                    }
                }
            }

            Assert.That(written, Has.All.GreaterThan(0));
            Assert.That(written.Sum(), Is.EqualTo(4 * rig.View.quadCount));
            Assert.That(rig.View.quadCount, Is.LessThanOrEqualTo(rig.VertexCount / 4 + rig.CellCount));
        }

        [Test]
        public void QuadsOfTheCells_FollowOneAnother()
        {
            WingRig rig = Bake();
            int next = 0;
            for (int cell = 0; cell < rig.CellCount; cell++)
            {
                Assert.That(rig.View.skinCells[cell].firstQuad, Is.EqualTo(next));
                next += rig.View.skinCells[cell].quadCount;
            }

            Assert.That(next, Is.EqualTo(rig.View.quadCount));
        }

        [Test]
        public void Tangents_LieBesideTheirVertices()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.tangents = Enumerable.Range(0, surface.positions.Length).Select(k => new Vector4(k, 2f * k, 3f * k, -1f)).ToArray();
            WingRig rig = Bake(TestWings.Fan(), surface);
            for (int quad = 0; quad < rig.View.quadCount; quad++)
            {
                for (int lane = 0; lane < 4; lane++)
                {
                    SkinTangentQuad t = rig.View.skinTangents[quad];
                    int vertex = rig.View.skinQuads[quad].target[lane];
                    Assert.That(new Vector4(t.tx[lane], t.ty[lane], t.tz[lane], t.tw[lane]), Is.EqualTo(surface.tangents[vertex]));
                }
            }
        }

        [Test]
        public void WithoutTangents_ThereAreNone()
        {
            Assert.That(Bake().View.skinTangents == null, Is.True);
        }

        [Test]
        public void MissingNormals_AreComputedFromTheTriangles()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.normals = null;
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].y = 0.1f * surface.positions[k].x;
            WingRig rig = Bake(TestWings.Fan(), surface);

            AssertNormals(rig, math.normalize(new float3(-0.1f, 1f, 0f)));
        }

        [Test]
        public void BrokenNormals_AreReplaced()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.normals[3] = Vector3.zero;
            surface.normals[40] = new Vector3(float.NaN, 0f, 0f);

            AssertNormals(Bake(TestWings.Fan(), surface), new float3(0f, 1f, 0f));
        }

        [Test]
        public void WhereBothSidesShareTheirVertices_NormalsPointUp()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.normals = null;
            surface.triangles = surface.triangles.Concat(surface.triangles.Reverse()).ToArray();

            AssertNormals(Bake(TestWings.Fan(), surface), new float3(0f, 1f, 0f));
        }

        private static void AssertNormals(WingRig rig, float3 expected)
        {
            for (int quad = 0; quad < rig.View.quadCount; quad++)
            {
                SkinQuad q = rig.View.skinQuads[quad];
                for (int lane = 0; lane < 4; lane++)
                    Assert.That(math.distance(new float3(q.nx[lane], q.ny[lane], q.nz[lane]), expected), Is.LessThan(1e-5f));
            }
        }
    }
}
