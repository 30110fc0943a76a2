using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Sheets and halves of a mesh, wherever they come in it and however large it is.</summary>
    public sealed class MeasuredMeshLaws
    {
        private readonly List<Mesh> m_Meshes = new List<Mesh>();

        [TearDown]
        public void DestroyMeshes()
        {
            m_Meshes.ForEach(Object.DestroyImmediate);
            m_Meshes.Clear();
        }

        [Test]
        public void SheetsOfATenthOfTheLargest_AndMore_Count([Values(0, 1, 2, 3)] int first, [Values(1e-3f, 1f, 1e3f)] float size)
        {
            float[] areas = { 1f, 0.105f, 0.095f, 0.5f };
            var sketch = new MeshSketch();
            for (int k = 0; k < areas.Length; k++)
                sketch.Sheet(new Vector3(0.5f, k, 0f), areas[(first + k) % areas.Length] * Vector3.right, Vector3.forward);
            var mesh = new MeasuredMesh(Made(sketch), Matrix4x4.Scale(size * Vector3.one));
            IEnumerable<float> found = mesh.Sheets().Select(sheet => sheet.shape.area / (size * size)).OrderBy(area => area);
            Assert.That(found, Is.EqualTo(new[] { 0.105f, 0.5f, 1f }).Within(1e-4f));
        }

        // Bodies, and sheets that reach over both sides, are no wings and set no measure.
        [Test]
        public void WhatIsNoSheetOfOneSide_SetsNoMeasure()
        {
            MeshSketch sketch = new MeshSketch().Box(new Vector3(9f, 0f, 0f), 5f * Vector3.one)
                .Sheet(new Vector3(-20f, 9f, 0f), 40f * Vector3.right, 9f * Vector3.forward)
                .Sheet(new Vector3(1f, 20f, 0f), Vector3.right, Vector3.forward);
            List<(WingShape shape, Vector3 point, int submesh)> sheets = new MeasuredMesh(Made(sketch), Matrix4x4.identity).Sheets();
            Assert.That(sheets.Select(sheet => sheet.point.y), Is.EqualTo(new[] { 20f }));
        }

        // By the height at which each lies: 0 and 1 in one submesh, 2 over two of them, 3 drawn by two of them.
        [Test]
        public void ASheet_IsOfTheSubmeshThatDrawsIt_AndOfNoneWhereSeveralDo()
        {
            MeshSketch sketch = new MeshSketch().Sheet(Vector3.right, Vector3.right, Vector3.forward)
                .NextSubmesh().Sheet(new Vector3(1f, 1f, 0f), Vector3.right, Vector3.forward)
                .Sheet(new Vector3(1f, 2f, 0f), Vector3.right, Vector3.forward);
            int shared = sketch.positions.Count;
            sketch.Sheet(new Vector3(1f, 3f, 0f), Vector3.right, Vector3.forward)
                .NextSubmesh().Sheet(new Vector3(2f, 2f, 0f), Vector3.right, Vector3.forward)
                .NextSubmesh().NextSubmesh();
            Mesh mesh = Made(sketch);
            IEnumerable<int> twice = mesh.GetTriangles(1).Where(vertex => vertex >= shared);
            mesh.SetTriangles(mesh.GetTriangles(2).Concat(twice).ToArray(), 2);
            mesh.SetIndices(new[] { 0, 1 }, MeshTopology.Lines, 3);
            var measured = new MeasuredMesh(mesh, Matrix4x4.identity);

            Assert.That(measured.Sheets().ToDictionary(sheet => Mathf.RoundToInt(sheet.point.y), sheet => sheet.submesh),
                Is.EquivalentTo(new Dictionary<int, int> { [0] = 0, [1] = 1, [2] = -1, [3] = -1 }));
            Assert.That(Enumerable.Range(0, 5).Select(measured.IsDrawn), Is.EqualTo(new[] { true, true, true, false, false }));
        }

        [Test]
        public void HalvesOfABox_ReachFromItsMiddleToItsRightAndLeftFace([Values(0, 1, 2)] int axis, [Values] bool ofSubmesh)
        {
            Mesh mesh = Boxes();
            Bounds box = ofSubmesh ? mesh.GetSubMesh(1).bounds : mesh.bounds;
            Quaternion turn = axis == 0 ? Quaternion.identity : Quaternion.Euler(0f, axis == 2 ? 90f : 0f, axis == 1 ? -90f : 0f);
            var toInsect = Matrix4x4.TRS(new Vector3(3f, -2f, 5f), turn, 2f * Vector3.one);
            var whole = WingShape.Of(box, toInsect);

            List<(WingShape shape, Vector3 point, int submesh)> halves = new MeasuredMesh(mesh, toInsect).Halves(ofSubmesh ? 1 : -1);

            halves.Sort((a, b) => a.shape.centroid.x.CompareTo(b.shape.centroid.x));
            Assert.That(halves.Select(half => half.submesh), Is.EqualTo(ofSubmesh ? new[] { 1, 1 } : new[] { -1, -1 }));
            Vector3 middle = whole.bounds.center, size = whole.bounds.size, towards = new Vector3(0.5f * size.x, 0f, 0f);
            Near(halves[0].shape.bounds.min, whole.bounds.min);
            Near(halves[0].shape.bounds.max, middle + 0.5f * new Vector3(0f, size.y, size.z));
            Near(halves[1].shape.bounds.min, middle - 0.5f * new Vector3(0f, size.y, size.z));
            Near(halves[1].shape.bounds.max, whole.bounds.max);
            Near(toInsect.MultiplyPoint3x4(halves[0].point), middle - towards);
            Near(toInsect.MultiplyPoint3x4(halves[1].point), middle + towards);
        }

        // The axis that reaches farthest to the side: not the one that points there most, nor the longest.
        [Test]
        public void OfAnObliqueBox_TheAxisThatReachesFarthestToTheSide_IsHalved([Values(30f, -30f)] float yaw)
        {
            Mesh mesh = Made(new MeshSketch().Box(Vector3.zero, new Vector3(2f, 18f, 8f)));
            List<(WingShape shape, Vector3 point, int submesh)> halves =
                new MeasuredMesh(mesh, Matrix4x4.Rotate(Quaternion.Euler(0f, yaw, 0f))).Halves(-1);
            Vector3 apart = halves[0].point - halves[1].point;
            Near(new Vector3(Mathf.Abs(apart.x), Mathf.Abs(apart.y), Mathf.Abs(apart.z)), new Vector3(0f, 0f, 8f));
        }

        [Test]
        public void AMeshThatCannotBeRead_IsMeasuredByItsBoxes()
        {
            Mesh mesh = Boxes();
            var toInsect = Matrix4x4.TRS(Vector3.one, Quaternion.Euler(10f, 20f, 30f), 2f * Vector3.one);
            Assert.That(new MeasuredMesh(mesh, toInsect).IsReadable);
            mesh.UploadMeshData(true);
            var measured = new MeasuredMesh(mesh, toInsect);
            Assert.That((measured.IsReadable, measured.SubmeshCount), Is.EqualTo((false, 2)));
            Assert.That(measured.Whole().bounds, Is.EqualTo(WingShape.Of(mesh.bounds, toInsect).bounds));
            Assert.That(measured.Submesh(1).bounds, Is.EqualTo(WingShape.Of(mesh.GetSubMesh(1).bounds, toInsect).bounds));
        }

        private Mesh Boxes() => Made(new MeshSketch().Box(new Vector3(0.3f, 0.5f, -0.2f), new Vector3(2f, 3f, 4f))
            .NextSubmesh().Box(new Vector3(1f, 2f, 3f), new Vector3(3f, 4f, 5f)));

        private static void Near(Vector3 found, Vector3 wanted) => Assert.That((found - wanted).magnitude, Is.LessThan(1e-4f));

        private Mesh Made(MeshSketch sketch)
        {
            m_Meshes.Add(sketch.ToMesh());
            return m_Meshes[m_Meshes.Count - 1];
        }
    }
}
