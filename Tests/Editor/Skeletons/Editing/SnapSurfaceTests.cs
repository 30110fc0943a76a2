using Alate.Catalogue;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    public sealed class SnapSurfaceTests
    {
        // One triangle in the plane y = 0: right angle at the origin, legs of length 1 along x and z.
        private static readonly SnapSurface s_Triangle = new SnapSurface(new SurfaceMesh
        {
            positions = new[] { Vector3.zero, new Vector3(0f, 0f, 1f), new Vector3(1f, 0f, 0f) },
            triangles = new[] { 0, 1, 2 },
        });

        [TestCase(0.2f, 0.5f, 0.3f, 0.2f, 0.3f, Description = "above the inside")]
        [TestCase(0.25f, -3f, 0.25f, 0.25f, 0.25f, Description = "below the inside")]
        [TestCase(-1f, 0.2f, 0.4f, 0f, 0.4f, Description = "beside an edge")]
        [TestCase(1f, 0f, 1f, 0.5f, 0.5f, Description = "beside the long edge")]
        [TestCase(3f, 1f, -2f, 1f, 0f, Description = "beyond a corner")]
        [TestCase(-1f, 1f, -2f, 0f, 0f, Description = "beyond the right angle")]
        public void ClosestPoint_OfATriangle_IsKnown(float x, float y, float z, float closestX, float closestZ)
        {
            Vector3 closest = s_Triangle.ClosestPoint(new Vector3(x, y, z));

            Assert.That(Vector3.Distance(closest, new Vector3(closestX, 0f, closestZ)), Is.LessThan(1e-6f));
        }

        [Test]
        public void ClosestPoint_IsNoFartherThanAnyPointOfTheSurface()
        {
            SurfaceMesh wing = InsectCatalogue.Find("monarch").Wings[0].CreateSurface(WingSide.Right);
            var surface = new SnapSurface(wing);
            var random = new System.Random(5);
            for (int k = 0; k < 50; k++)
            {
                var point = new Vector3((float)random.NextDouble(), (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
                float distance = Vector3.Distance(surface.ClosestPoint(point), point);
                for (int t = 0; t < wing.triangles.Length; t += 3)
                {
                    Vector3 centre = (wing.positions[wing.triangles[t]] + wing.positions[wing.triangles[t + 1]]
                        + wing.positions[wing.triangles[t + 2]]) / 3f;
                    Assert.That(distance, Is.LessThanOrEqualTo(Vector3.Distance(centre, point) + 1e-6f));
                }
            }
        }

        [Test]
        public void Ray_HitsTheFirstTriangle_FromEitherSide()
        {
            Assert.That(s_Triangle.TryHit(new Vector3(0.2f, 4f, 0.2f), new Vector3(0f, -2f, 0.1f), out Vector3 above));
            Assert.That(Vector3.Distance(above, new Vector3(0.2f, 0f, 0.4f)), Is.LessThan(1e-6f));
            Assert.That(s_Triangle.TryHit(new Vector3(0.2f, -1f, 0.2f), Vector3.up, out Vector3 below));
            Assert.That(Vector3.Distance(below, new Vector3(0.2f, 0f, 0.2f)), Is.LessThan(1e-6f));
        }

        [TestCase(0.7f, 0.7f, -1f, Description = "beside it")]
        [TestCase(0.2f, 0.2f, 1f, Description = "away from it")]
        public void Ray_MissesOtherwise(float x, float z, float direction) =>
            Assert.That(s_Triangle.TryHit(new Vector3(x, 2f, z), new Vector3(0f, direction, 0f), out _), Is.False);

        [Test]
        public void FlatTriangles_HaveAClosestPoint_AndAreNeverHit()
        {
            var line = new SnapSurface(new SurfaceMesh
            {
                positions = new[] { Vector3.zero, Vector3.right, 2f * Vector3.right },
                triangles = new[] { 0, 1, 2 },
            });

            Assert.That(line.ClosestPoint(new Vector3(1.5f, 1f, 0f)), Is.EqualTo(new Vector3(1.5f, 0f, 0f)));
            Assert.That(line.TryHit(new Vector3(1f, 1f, 0f), Vector3.down, out _), Is.False);
        }

        [Test]
        public void EmptySurface_LeavesPointsWhereTheyAre()
        {
            var empty = new SnapSurface(new SurfaceMesh { positions = new Vector3[0], triangles = new int[0] });

            Assert.That(empty.ClosestPoint(Vector3.one), Is.EqualTo(Vector3.one));
        }
    }
}
