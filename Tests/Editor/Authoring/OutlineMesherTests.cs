using System;
using System.Collections.Generic;
using Alate.Geometry;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    public sealed class OutlineMesherTests
    {
        private const double k_LeastAngle = 20.0;

        private static IEnumerable<TestCaseData> Cases()
        {
            foreach (DrawnWing wing in DrawnWing.All)
            {
                foreach (int triangles in new[] { 50, 121, 300, 1000, 4192 })
                {
                    yield return new TestCaseData(wing.Name, PlanPaths.Counterclockwise(wing.In(1000).Outline), triangles)
                        .SetName($"{{m}}({wing.Name}, {triangles})");
                }
            }
        }

        [TestCaseSource(nameof(Cases))]
        public void Mesh_HasTheExactCountOfGoodTriangles(string name, object outline, int triangles)
        {
            TriangleLinks mesh = OutlineMesher.Mesh((PlanPoint[])outline, triangles, out int rim);

            Assert.That(mesh.SideCount, Is.EqualTo(3 * triangles), name);
            Assert.That(
                2 * (mesh.points.Length - rim) + rim - 2, Is.EqualTo(triangles), "every point is used once, and the rim is a single loop");
            Assert.That(LeastAngle(mesh), Is.GreaterThan(k_LeastAngle));
        }

        [TestCaseSource(nameof(Cases))]
        public void Mesh_FillsTheOutlineWithoutOverlap(string name, object outline, int triangles)
        {
            var wing = (PlanPoint[])outline;
            TriangleLinks mesh = OutlineMesher.Mesh(wing, triangles, out int rim);

            double sum = 0.0;
            for (int side = 0; side < mesh.SideCount; side += 3)
                sum += 0.5 * mesh.Area(mesh.corners[side], mesh.corners[side + 1], mesh.corners[side + 2]);
            PlanPoint[] loop = Rim(mesh, rim);
            Assert.That(sum, Is.EqualTo(Polygon.Area(loop)).Within(1e-9 * sum), name);
            double size = Math.Sqrt(4.0 * Polygon.Area(wing) / (Math.Sqrt(3.0) * triangles));
            Assert.That(PlanPaths.Hausdorff(loop, wing), Is.LessThan(0.5 * size), "the rim follows the outline to half a triangle's side");
            foreach (PlanPoint point in loop)
                Assert.That(Polyline.Distance(wing, point, true), Is.LessThan(1e-3 * size), "the rim's points lie on the outline");
        }

        [Test]
        public void InnerPoints_LieInsideTheRim()
        {
            PlanPoint[] wing = PlanPaths.Counterclockwise(DrawnWing.Tailed().In(1000).Outline);

            TriangleLinks mesh = OutlineMesher.Mesh(wing, 700, out int rim);

            PlanPoint[] loop = Rim(mesh, rim);
            for (int k = rim; k < mesh.points.Length; k++)
                Assert.That(Polygon.Contains(loop, mesh.points[k]), Is.True, $"point {k}");
        }

        [Test]
        public void SameOutline_GivesTheSameMesh()
        {
            PlanPoint[] wing = PlanPaths.Counterclockwise(DrawnWing.Scalloped().In(1000).Outline);

            TriangleLinks one = OutlineMesher.Mesh(wing, 500, out _), other = OutlineMesher.Mesh(wing, 500, out _);

            Assert.That(other.corners, Is.EqualTo(one.corners));
            Assert.That(other.points, Is.EqualTo(one.points));
        }

        [Test]
        public void OutlineOfFarMoreCornersThanTriangles_IsRefused()
        {
            var comb = new List<PlanPoint>();
            for (int k = 0; k < 60; k++)
            {
                comb.Add(new PlanPoint(10 * k, 0));
                comb.Add(new PlanPoint(10 * k + 5, 0));
                comb.Add(new PlanPoint(10 * k + 5, 300));
                comb.Add(new PlanPoint(10 * k + 8, 300));
                comb.Add(new PlanPoint(10 * k + 8, 0.01 * k));
            }

            comb.Add(new PlanPoint(600, -20));
            comb.Add(new PlanPoint(0, -20));
            comb.Reverse();

            Assert.That(
                () => OutlineMesher.Mesh(comb.ToArray(), 50, out _), Throws.ArgumentException.With.Message.Contains("50 triangles"));
        }

        private static PlanPoint[] Rim(TriangleLinks mesh, int count)
        {
            var rim = new PlanPoint[count];
            Array.Copy(mesh.points, rim, count);
            return rim;
        }

        private static double LeastAngle(TriangleLinks mesh)
        {
            double least = 180.0;
            for (int side = 0; side < mesh.SideCount; side++)
            {
                PlanPoint at = mesh.points[mesh.corners[side]], a = mesh.points[mesh.End(side)] - at, b = mesh.points[mesh.Apex(side)] - at;
                least = Math.Min(least, Math.Atan2(PlanPoint.Cross(a, b), PlanPoint.Dot(a, b)) * 180.0 / Math.PI);
            }

            return least;
        }
    }
}
