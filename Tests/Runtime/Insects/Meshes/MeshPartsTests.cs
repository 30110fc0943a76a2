using System;
using System.Collections.Generic;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Tests
{
    public sealed class MeshPartsTests
    {
        private readonly List<Mesh> m_Meshes = new List<Mesh>();

        [TearDown]
        public void DestroyMeshes()
        {
            m_Meshes.ForEach(Object.DestroyImmediate);
            m_Meshes.Clear();
        }

        [Test]
        public void TheWholeMesh_IsAllSubmeshes_WithoutVerticesThatNoneUses()
        {
            MeshSketch sketch = new MeshSketch().Stray(Vector3.one).Wing(Vector3.zero, 1f, 0.5f).Stray(Vector3.up);
            Mesh mesh = Made(sketch.NextSubmesh().Wing(Vector3.zero, -1f, 0.5f));

            MeshSelection all = MeshParts.Select(mesh, WingPart.WholeMesh, 7, Vector3.zero);

            Assert.That(all.vertices, Has.Length.EqualTo(mesh.vertexCount - 2).And.Ordered.And.Unique);
            Assert.That(all.vertices, Has.None.EqualTo(0).And.None.EqualTo(36));
            Assert.That(Corners(all), Is.EqualTo(mesh.triangles));
        }

        [Test]
        public void ASubmesh_KeepsItsTrianglesAndTheirWinding()
        {
            Mesh mesh = Made(new MeshSketch().Box(Vector3.zero, Vector3.one).NextSubmesh().Wing(Vector3.right, 1f, 0.5f));

            MeshSelection wing = MeshParts.Select(mesh, WingPart.Submesh, 1, Vector3.zero);

            Assert.That(Corners(wing), Is.EqualTo(mesh.GetTriangles(1)));
            Assert.That(wing.vertices, Has.Length.EqualTo(35).And.All.GreaterThanOrEqualTo(8));
        }

        [Test]
        public void LinesInTheMesh_AreNoPartOfTheWhole()
        {
            Mesh mesh = Made(new MeshSketch().Wing(Vector3.zero, 1f, 0.5f).NextSubmesh().Wing(Vector3.zero, -1f, 0.5f));
            mesh.SetIndices(new[] { 40, 41 }, MeshTopology.Lines, 1);

            Assert.That(Corners(MeshParts.Select(mesh, WingPart.WholeMesh, 0, Vector3.zero)), Is.EqualTo(mesh.GetTriangles(0)));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void AConnectedPart_IsTheWingAtThePoint_WeldedOrNot(bool split)
        {
            MeshSketch sketch = new MeshSketch().Wing(new Vector3(0.1f, 0f, 0f), 1f, 0.5f).Wing(new Vector3(-0.1f, 0f, 0f), -1f, 0.5f);
            Mesh mesh = Made(split ? sketch.Split() : sketch);

            foreach (float side in new[] { 1f, -1f })
            {
                MeshSelection wing = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, new Vector3(0.6f * side, 0.2f, -0.1f));

                Assert.That(wing.triangles, Has.Length.EqualTo(mesh.triangles.Length / 2));
                foreach (Vector3 p in MeshParts.Surface(mesh, wing).positions)
                    Assert.That(p.x * side, Is.InRange(0.1f - 1e-6f, 1.1f + 1e-6f));
            }
        }

        [Test]
        public void AConnectedPart_GoesThroughSeamsOfMaterials()
        {
            MeshSketch sketch = new MeshSketch().Sheet(Vector3.zero, Vector3.right, Vector3.forward).NextSubmesh();
            Mesh mesh = Made(sketch.Sheet(Vector3.right, Vector3.right, Vector3.forward).Box(new Vector3(5f, 0f, 0f), Vector3.one));

            MeshSelection wing = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, Vector3.zero);

            Assert.That(wing.triangles, Has.Length.EqualTo(2 * mesh.GetTriangles(0).Length));
        }

        [Test]
        public void ZerosOfEitherSign_AreTheSamePlace()
        {
            MeshSketch sketch = new MeshSketch().Sheet(Vector3.zero, Vector3.right, Vector3.forward);
            int half = sketch.positions.Count;
            sketch.Sheet(Vector3.zero, Vector3.left, Vector3.forward);
            for (int vertex = half; vertex < sketch.positions.Count; vertex++)
                sketch.positions[vertex] = Vector3.Scale(sketch.positions[vertex], new Vector3(1f, -1f, 1f));
            Assert.That(1f / sketch.positions[half].y, Is.EqualTo(float.NegativeInfinity), "minus zero");

            Assert.That(MeshParts.Parts(Made(sketch)), Has.Count.EqualTo(1));
        }

        [TestCase(1f, 0f)]
        [TestCase(1e-3f, 0f)]
        [TestCase(1e4f, 0f)]
        [TestCase(1f, 50f)]
        public void Seams_AreWeldedAcrossRoundings_ButNotAcrossGaps(float size, float offset)
        {
            // A sheet in eight strips whose common edges differ by the rounding of a float; then with gaps of a hundred-thousandth.
            foreach (float gap in new[] { 0f, 1e-5f * (1f + offset) })
            {
                var sketch = new MeshSketch();
                for (int strip = 0; strip < 8; strip++)
                {
                    var corner = new Vector3(strip * (1f / 7f) + gap * strip, 0f, 0f);
                    sketch.Sheet(corner, new Vector3(1f / 7f, 0f, 0f), new Vector3(0.1f, 0.1f, 0.7f), 3, 4);
                }

                for (int vertex = 0; vertex < sketch.positions.Count; vertex++)
                    sketch.positions[vertex] = size * (sketch.positions[vertex] + offset * Vector3.one) / 3f;

                Assert.That(MeshParts.Parts(Made(sketch)), Has.Count.EqualTo(gap == 0f ? 1 : 8), $"gap {gap}");
            }
        }

        [Test]
        public void EverySeam_IsWelded_WhereverItLies()
        {
            // Squares of two triangles whose common corners differ in the last bits of their coordinates.
            const int k_Squares = 3000;
            var random = new System.Random(8);
            float Any() => 2f * (float)random.NextDouble() - 1f;
            float Nearly(float value) => value * (1f + 1.2e-7f * random.Next(-2, 3));
            var sketch = new MeshSketch();
            for (int square = 0; square < k_Squares; square++)
                sketch.Sheet(new Vector3(Any(), Any(), Any()), 1e-3f * Vector3.right, 1e-3f * Vector3.forward, 1, 1);
            sketch.Split();
            for (int vertex = 0; vertex < sketch.positions.Count; vertex++)
            {
                Vector3 p = sketch.positions[vertex];
                sketch.positions[vertex] = new Vector3(Nearly(p.x), Nearly(p.y), Nearly(p.z));
            }

            Assert.That(MeshParts.Parts(Made(sketch)), Has.Count.EqualTo(k_Squares));
        }

        [Test]
        public void TheNearestTriangle_IsFoundByItsFace_NotItsCorners()
        {
            // The point is 1 above the middle of a large triangle whose corners are far, and 2 from a small sheet.
            Mesh mesh = Made(new MeshSketch()
                .Sheet(new Vector3(-50f, 0f, -50f), new Vector3(100f, 0f, 0f), new Vector3(0f, 0f, 100f), 1, 1)
                .Sheet(new Vector3(0f, 3f, 0f), Vector3.right, Vector3.forward));

            MeshSelection part = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, new Vector3(5f, 1f, -5f));
            Assert.That(part.vertices, Is.EqualTo(new[] { 0, 1, 2, 3 }));
            part = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, new Vector3(0.5f, 2.1f, 0.5f));
            Assert.That(part.vertices, Has.Length.EqualTo(35));
        }

        [Test]
        public void DistanceToATriangle_IsTheLeastOverItsPoints()
        {
            var random = new System.Random(5);
            Vector3 Any() => new Vector3((float)random.NextDouble(), (float)random.NextDouble(), (float)random.NextDouble());
            for (int round = 0; round < 200; round++)
            {
                Vector3 a = Any(), b = Any(), c = Any(), point = 3f * Any() - Vector3.one;
                float least = float.MaxValue;
                for (int i = 0; i <= 100; i++)
                {
                    for (int j = 0; i + j <= 100; j++)
                        least = Mathf.Min(least, (a + (b - a) * (i / 100f) + (c - a) * (j / 100f) - point).magnitude);
                }

                float distance = Mathf.Sqrt(TriangleDistance.Square(point, a, b, c));
                Assert.That(distance, Is.LessThan(least + 1e-6f).And.GreaterThan(least - 0.03f));
            }
        }

        [Test]
        public void Surface_CarriesTheVerticesOfTheSelection()
        {
            Mesh mesh = Made(new MeshSketch().Box(Vector3.zero, Vector3.one).NextSubmesh().Wing(Vector3.right, 1f, 0.5f));
            mesh.tangents = Array.ConvertAll(mesh.vertices, p => new Vector4(p.x, p.y, p.z, 1f));
            MeshSelection wing = MeshParts.Select(mesh, WingPart.Submesh, 1, Vector3.zero);

            SurfaceMesh surface = MeshParts.Surface(mesh, wing);

            Assert.That(surface.name, Is.EqualTo(mesh.name));
            for (int k = 0; k < wing.vertices.Length; k++)
            {
                Assert.That(surface.positions[k], Is.EqualTo(mesh.vertices[wing.vertices[k]]));
                Assert.That(surface.normals[k], Is.EqualTo(mesh.normals[wing.vertices[k]]));
                Assert.That(surface.tangents[k], Is.EqualTo(mesh.tangents[wing.vertices[k]]));
            }

            Assert.That(surface.triangles, Is.EqualTo(wing.triangles));
        }

        [Test]
        public void Parts_HaveTheirAreaBoxAndPoint()
        {
            Mesh mesh = Made(new MeshSketch()
                .Box(Vector3.up, new Vector3(1f, 2f, 3f))
                .Sheet(new Vector3(2f, 0f, 0f), 2f * Vector3.right, Vector3.forward));

            List<(MeshSelection selection, Vector3 point)> parts = MeshParts.Parts(mesh);

            Assert.That(parts, Has.Count.EqualTo(2));
            List<WingShape> shapes = parts.ConvertAll(part => WingShape.Of(mesh.vertices, part.selection, Matrix4x4.identity));
            Assert.That(shapes[0].area, Is.EqualTo(22f).Within(1e-4f));
            Assert.That(shapes[0].bounds.size, Is.EqualTo(new Vector3(1f, 2f, 3f)));
            Assert.That((shapes[0].centroid - Vector3.up).magnitude, Is.LessThan(1e-5f));
            Assert.That(shapes[1].area, Is.EqualTo(2f).Within(1e-5f));
            Assert.That((shapes[1].centroid - new Vector3(3f, 0f, 0.5f)).magnitude, Is.LessThan(1e-5f));
            foreach ((MeshSelection selection, Vector3 point) part in parts)
            {
                MeshSelection again = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, part.point);
                Assert.That(again.vertices, Is.EqualTo(part.selection.vertices));
                Assert.That(again.triangles, Is.EqualTo(part.selection.triangles));
            }
        }

        // A quadratic search would take minutes.
        [TestCase(true)]
        [TestCase(false)]
        public void AHundredThousandTriangles_AreOnePart(bool split)
        {
            MeshSketch sketch = new MeshSketch().Sheet(Vector3.right, Vector3.right, Vector3.forward, 250, 200);
            sketch.Sheet(Vector3.left, Vector3.left, Vector3.forward, 2, 2);
            if (split)
                sketch.Split();
            Mesh mesh = Made(sketch);

            MeshSelection part = MeshParts.Select(mesh, WingPart.ConnectedPart, 0, new Vector3(1.5f, 1f, 0.5f));

            Assert.That(part.triangles, Has.Length.EqualTo(300000));
        }

        [Test]
        public void AHundredThousandPieces_AreAsManyParts()
        {
            MeshSketch sketch = new MeshSketch().Sheet(Vector3.zero, Vector3.right, Vector3.forward, 250, 200).Split();
            for (int vertex = 0; vertex < sketch.positions.Count; vertex++)
                sketch.positions[vertex] += vertex / 3 * new Vector3(0f, 0.01f, 0f);
            Mesh mesh = Made(sketch);

            Assert.That(MeshParts.Parts(mesh), Has.Count.EqualTo(100000));
        }

        [Test]
        public void WrongAsking_IsRefused_InOneLineThatNamesTheMesh()
        {
            Mesh mesh = Made(new MeshSketch().Wing(Vector3.zero, 1f, 0.5f).NextSubmesh().Wing(Vector3.zero, 1f, 0.5f).NextSubmesh());
            mesh.SetIndices(new[] { 1, 2 }, MeshTopology.Lines, 1);

            Refuses(mesh, WingPart.Submesh, 3, "Mesh 'Sketch' has no submesh 3: it has 3, numbered from 0.");
            Refuses(mesh, WingPart.Submesh, -1, "Mesh 'Sketch' has no submesh -1: it has 3, numbered from 0.");
            Refuses(mesh, WingPart.Submesh, 1, "Submesh 1 of mesh 'Sketch' consists of Lines; a wing needs Triangles.");
            Refuses(mesh, WingPart.Submesh, 2, "Submesh 2 of mesh 'Sketch' has no triangles.");
            Refuses(Made(new MeshSketch()), WingPart.WholeMesh, 0, "Mesh 'Sketch' has no triangles.");
            Refuses(Made(new MeshSketch()), WingPart.ConnectedPart, 0, "Mesh 'Sketch' has no triangles.");
            Refuses(mesh, (WingPart)9, 0, "9 is not a part of a mesh.");
            Assert.That(() => MeshParts.Select(null, WingPart.WholeMesh, 0, Vector3.zero), Throws.ArgumentNullException);
            Assert.That(
                () => MeshParts.Select(mesh, WingPart.ConnectedPart, 0, new Vector3(float.NaN, 0f, 0f)),
                Throws.ArgumentException.With.Message.Contains("is not finite"));
        }

        [Test]
        public void AMeshThatIsNotReadable_IsRefused()
        {
            Mesh mesh = Made(new MeshSketch().Wing(Vector3.zero, 1f, 0.5f));
            mesh.UploadMeshData(true);

            foreach (WingPart part in Enum.GetValues(typeof(WingPart)))
                Refuses(mesh, part, 0, "Mesh 'Sketch' is not readable: turn on Read/Write in its import settings.");
            Assert.That(() => MeshParts.Parts(mesh), Throws.ArgumentException);
        }

        private static void Refuses(Mesh mesh, WingPart part, int submesh, string message) =>
            Assert.That(() => MeshParts.Select(mesh, part, submesh, Vector3.zero), Throws.ArgumentException.With.Message.EqualTo(message));

        private static int[] Corners(MeshSelection selection) => Array.ConvertAll(selection.triangles, place => selection.vertices[place]);

        private Mesh Made(MeshSketch sketch)
        {
            m_Meshes.Add(sketch.ToMesh());
            return m_Meshes[m_Meshes.Count - 1];
        }
    }
}
