using System;
using System.Linq;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Meshes as they come out of real tools.</summary>
    public sealed class SurfaceTests : RigFixture
    {
        [Test]
        public void DuplicateTriangles_CountOnce()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.triangles = surface.triangles.Concat(surface.triangles.Take(90)).ToArray();

            AssertSameWing(Bake(TestWings.Fan(), surface), Bake());
        }

        [Test]
        public void TheTwoSidesOfADoubleSidedWing_CountOnce()
        {
            SurfaceMesh single = TestWings.Ellipse();
            int vertices = single.positions.Length;
            var both = new SurfaceMesh
            {
                positions = single.positions.Concat(single.positions).ToArray(),
                normals = single.normals.Concat(single.normals.Select(n => -n)).ToArray(),
                triangles = single.triangles.Concat(single.triangles.Reverse().Select(index => index + vertices)).ToArray(),
            };
            WingRig rig = Bake(TestWings.Fan(), both);

            AssertSameWing(rig, Bake());
            Assert.That(rig.VertexCount, Is.EqualTo(2 * vertices));
        }

        [Test]
        public void AThinClosedShell_HasTheAreaOfOneSide()
        {
            const int k_Columns = 12, k_Rows = 6;
            SurfaceMesh top = TestWings.Ellipse(k_Columns, k_Rows), bottom = TestWings.Ellipse(k_Columns, k_Rows);
            int vertices = top.positions.Length;
            for (int k = 0; k < vertices; k++)
            {
                int column = k / (k_Rows + 1), row = k % (k_Rows + 1);
                bool rim = column == 0 || column == k_Columns || row == 0 || row == k_Rows;
                top.positions[k].y = rim ? 0f : 0.004f;
                bottom.positions[k].y = rim ? 0f : -0.004f;
            }

            var shell = new SurfaceMesh
            {
                positions = top.positions.Concat(bottom.positions).ToArray(),
                triangles = top.triangles.Concat(bottom.triangles.Reverse().Select(index => index + vertices)).ToArray(),
            };
            WingRig rig = Bake(TestWings.Fan(), shell), flat = Bake();

            Assert.That(rig.Area, Is.EqualTo(flat.Area).Within(0.01f * flat.Area));
            Assert.That(rig.JointMasses.ToArray(), Is.EqualTo(flat.JointMasses.ToArray()).Within(2e-3f));
        }

        [Test]
        public void TrianglesWithoutArea_ChangeNothing()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.triangles = new[] { 3, 3, 4, 5, 5, 5, 0, 7, 14 }.Concat(surface.triangles).ToArray();

            AssertSameWing(Bake(TestWings.Fan(), surface), Bake());
        }

        [Test]
        public void UnusedVertices_ChangeNothingButAreKept()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.positions = surface.positions.Concat(new[] { new Vector3(50f, 3f, 9f), new Vector3(-8f, 0f, 0f) }).ToArray();
            surface.normals = null;
            WingRig rig = Bake(TestWings.Fan(), surface);

            AssertSameWing(rig, Bake());
            Assert.That(rig.Frame.length, Is.EqualTo(1f));
            Assert.That(rig.VertexCount, Is.EqualTo(surface.positions.Length));
        }

        [Test]
        public void TheOrderOfTriangles_DoesNotMatter()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            surface.triangles = surface.triangles.Reverse().ToArray();

            AssertSameWing(Bake(TestWings.Fan(), surface), Bake());
        }

        [Test]
        public void ACamberedWing_IsWeighedByItsPlan()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            for (int k = 0; k < surface.positions.Length; k++)
                surface.positions[k].y = 0.05f * math.sin(6f * surface.positions[k].z);
            WingRig rig = Bake(TestWings.Fan(), surface), flat = Bake();

            Assert.That(rig.VertexWeights.ToArray(), Is.EqualTo(flat.VertexWeights.ToArray()));
        }

        [Test]
        public void Submeshes_AreOneWing()
        {
            SurfaceMesh surface = TestWings.Ellipse();
            var mesh = TestWings.ToMesh(surface);
            int half = surface.triangles.Length / 6 * 3;
            mesh.subMeshCount = 2;
            mesh.SetTriangles(surface.triangles.Take(half).ToArray(), 0);
            mesh.SetTriangles(surface.triangles.Skip(half).ToArray(), 1);

            AssertSameWing(BakeMesh(mesh), Bake());
        }

        [Test]
        public void AMesh_IsTheSameAsItsArrays()
        {
            WingRig rig = BakeMesh(TestWings.ToMesh(TestWings.Ellipse())), arrays = Bake();

            AssertSameWing(rig, arrays);
            Assert.That(rig.VertexWeights.ToArray(), Is.EqualTo(arrays.VertexWeights.ToArray()));
        }

        [Test]
        public void MoreVerticesThan16BitsCount_AreAllKept()
        {
            SurfaceMesh surface = TestWings.Ellipse(300, 230);
            var mesh = TestWings.ToMesh(surface);
            WingRig rig = BakeMesh(mesh, 256);

            Assert.That(rig.VertexCount, Is.EqualTo(301 * 231).And.GreaterThan(ushort.MaxValue));
            Assert.That(rig.TriangleCount, Is.EqualTo(2 * 300 * 230));
            Assert.That(rig.VertexJoints[rig.VertexCount - 1].y, Is.GreaterThan(0));
        }

        [Test]
        public void AMeshThatIsNotReadable_IsRefusedByName()
        {
            var mesh = TestWings.ToMesh(TestWings.Ellipse());
            mesh.UploadMeshData(true);

            string message = Assert.Throws<ArgumentException>(() => BakeMesh(mesh)).Message;
            Assert.That(message, Does.Contain("Ellipse").And.Contain("Read/Write"));
        }

        [Test]
        public void AMeshOfVerticesAlone_HasNoTriangles()
        {
            var mesh = new Mesh { name = "Points", vertices = TestWings.Ellipse().positions };

            Assert.That(Assert.Throws<ArgumentException>(() => BakeMesh(mesh)).Message, Does.Contain("no triangles"));
        }

        private WingRig BakeMesh(Mesh mesh, int patchCount = 0) =>
            Keep(WingRig.Bake(TestWings.Fan(), mesh, new WingRigSettings { patchCount = patchCount }));

        private static void AssertSameWing(WingRig rig, WingRig expected)
        {
            Assert.That(rig.TriangleCount, Is.EqualTo(expected.TriangleCount));
            Assert.That(rig.PatchCount, Is.EqualTo(expected.PatchCount));
            Assert.That(rig.Area, Is.EqualTo(expected.Area).Within(1e-6f));
            for (int joint = 0; joint < expected.JointCount; joint++)
                Assert.That(rig.JointMasses[joint], Is.EqualTo(expected.JointMasses[joint]).Within(1e-6f), $"joint {joint}");
        }
    }
}
