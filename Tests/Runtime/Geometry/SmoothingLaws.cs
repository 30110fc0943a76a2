using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of triangles that are made more even.</summary>
    public sealed class SmoothingLaws
    {
        [Test]
        public void ThePointWithinARegularRim_GoesToItsMiddle([Values(5, 6, 8)] int count)
        {
            PlanPoint[] points = Ring(count, 1.0, 1.0).Append(new PlanPoint(0.4, -0.3)).ToArray();
            TriangleLinks mesh = DelaunayTriangulation.Inside(points, count);
            TriangleSmoothing.Run(mesh, count);
            Assert.That(Math.Sqrt(mesh.points[count].LengthSquared), Is.LessThan(1e-3));
        }

        [Test]
        public void ScatteredTriangles_BecomeEven_AndTheRimStays()
        {
            foreach (uint seed in Seeds.First(5))
            {
                var random = new Random(seed);
                List<PlanPoint> points = Ring(30, 3.0, 3.0).ToList();
                while (points.Count < 120)
                {
                    var place = new PlanPoint(6.0 * random.NextDouble() - 3.0, 6.0 * random.NextDouble() - 3.0);
                    if (place.LengthSquared < 7.5)
                        points.Add(place);
                }

                TriangleLinks mesh = DelaunayTriangulation.Inside(points.ToArray(), 30);
                double[] before = Qualities(mesh);
                double area = Area(mesh);
                TriangleSmoothing.Run(mesh, 30);
                double[] after = Qualities(mesh);
                Assert.That(after.Average(), Is.GreaterThan(before.Average() + 0.1).And.GreaterThan(0.88), $"seed {seed}");
                Assert.That(after.Min(), Is.GreaterThan(0.45), $"seed {seed}");
                Assert.That(Area(mesh), Is.EqualTo(area).Within(1e-9));
                for (int k = 0; k < 30; k++)
                    Assert.That((mesh.points[k] - points[k]).LengthSquared, Is.Zero);
                for (int side = 0; side < mesh.SideCount; side++)
                    Assert.That(mesh.IsAgainstDelaunay(side) && mesh.CanFlip(side), Is.False, $"seed {seed}");
            }
        }

        // In a slender rim the point is where the worst triangle around it is best: as good as anywhere on a fine grid.
        [Test]
        public void ACornerOfSlenderTriangles_GoesToItsBestPlace([Values(0.2, 0.35)] double width, [Values(4, 5, 6)] int count)
        {
            foreach (uint seed in Seeds.First(6))
            {
                var random = new Random(seed);
                PlanPoint[] rim = Ring(count, 1.0, width);
                PlanPoint start = rim[0] * (0.3 + 0.4 * random.NextDouble()) + rim[1] * (0.2 * random.NextDouble());
                PlanPoint[] points = rim.Append(start).ToArray();
                TriangleLinks mesh = DelaunayTriangulation.Inside(points, count);
                TriangleSmoothing.Run(mesh, count);
                var around = new List<(PlanPoint B, PlanPoint C)>();
                for (int side = 0; side < mesh.SideCount; side++)
                {
                    if (mesh.corners[side] == count)
                        around.Add((mesh.points[mesh.End(side)], mesh.points[mesh.Apex(side)]));
                }

                double Worst(PlanPoint place) => around.Min(side => TriangleSmoothing.Quality(place, side.B, side.C));
                double found = Worst(mesh.points[count]), best = 0.0;
                for (double x = -1.0; x < 1.0; x += 0.01)
                {
                    for (double z = -width; z < width; z += 0.01)
                        best = Math.Max(best, Worst(new PlanPoint(x, z)));
                }

                Assert.That(found, Is.GreaterThan(Math.Min(best, 0.7) - 0.05), $"seed {seed}: {best} on the grid");
            }
        }

        [Test]
        public void ARimThatCrossesItself_OrPassesThroughAPoint_IsRefused()
        {
            PlanPoint[] crossing = new[]
            {
                new PlanPoint(0, 0), new PlanPoint(4, 4), new PlanPoint(4, 0.3), new PlanPoint(0, 4), new PlanPoint(1, 2),
            };
            Assert.That(() => DelaunayTriangulation.Inside(crossing, 4),
                Throws.ArgumentException.With.Message.EqualTo("The rim of the mesh crosses itself."));
            PlanPoint[] through = new[]
            {
                new PlanPoint(0, 0), new PlanPoint(4, 0), new PlanPoint(4, 4), new PlanPoint(0, 4), new PlanPoint(2, 0),
            };
            Assert.That(() => DelaunayTriangulation.Inside(through, 4), Throws.ArgumentException.With.Message.Contains("rim of the mesh"));
        }

        // A rim whose sides others cross: what is forced in is there, and the rest obeys Delaunay's condition as far as it may.
        [Test]
        public void ARimThatManySidesCross_IsForcedIn()
        {
            var rim = new List<PlanPoint> { new PlanPoint(0, 0), new PlanPoint(30, 0.1), new PlanPoint(30, 1.2) };
            for (int k = 29; k > 0; k--)
                rim.Add(new PlanPoint(k, k % 2 == 0 ? 1.0 : 0.25));
            rim.Add(new PlanPoint(0, 1));
            AssertForced(rim.ToArray(), "");
        }

        // A long side between the teeth of two combs: neighbours across it are flipped away one after the other.
        [Test]
        public void ALongSideBetweenTwoCombs_IsForcedIn()
        {
            foreach (uint seed in Seeds.First(100))
            {
                var random = new Random(seed);
                int teeth = random.NextInt(4, 30);
                var rim = new List<PlanPoint> { new PlanPoint(0, 0), new PlanPoint(teeth, 0.01), new PlanPoint(teeth, 1.2) };
                for (int k = teeth - 1; k >= 0; k--)
                    rim.Add(new PlanPoint(k + 0.4 * random.NextDouble(), 0.1 + 0.9 * random.NextDouble()));
                rim.AddRange(new[] { new PlanPoint(-2, 1.2), new PlanPoint(-2, -1.2), new PlanPoint(teeth, -1.2) });
                for (int k = teeth - 1; k >= 0; k--)
                    rim.Add(new PlanPoint(k + 0.4 * random.NextDouble(), -0.1 - 0.9 * random.NextDouble()));
                AssertForced(rim.ToArray(), $"seed {seed}");
            }
        }

        private static void AssertForced(PlanPoint[] points, string what)
        {
            TriangleLinks mesh = DelaunayTriangulation.Inside(points, points.Length);
            Assert.That(mesh.SideCount, Is.EqualTo(3 * (points.Length - 2)), what);
            Assert.That(Area(mesh), Is.EqualTo(Polygon.Area(points)).Within(1e-9), what);
            int[] rimSides = Enumerable.Range(0, mesh.SideCount).Where(side => mesh.twins[side] < 0).ToArray();
            Assert.That(rimSides.Select(side => mesh.corners[side]), Is.EquivalentTo(Enumerable.Range(0, points.Length)), what);
            Assert.That(rimSides.All(side => mesh.End(side) == (mesh.corners[side] + 1) % points.Length), what);
            Assert.That(Qualities(mesh).Min(), Is.Positive, what);
            for (int side = 0; side < mesh.SideCount; side++)
                Assert.That(mesh.IsAgainstDelaunay(side) && mesh.CanFlip(side), Is.False, $"{what}, side {side}");
        }

        private static PlanPoint[] Ring(int count, double x, double z) => Enumerable.Range(0, count)
            .Select(k => new PlanPoint(x * Math.Cos(2.0 * Math.PI * k / count), z * Math.Sin(2.0 * Math.PI * k / count))).ToArray();

        private static double Area(TriangleLinks mesh) => Enumerable.Range(0, mesh.SideCount / 3)
            .Sum(k => 0.5 * mesh.Area(mesh.corners[3 * k], mesh.corners[3 * k + 1], mesh.corners[3 * k + 2]));

        private static double[] Qualities(TriangleLinks mesh) => Enumerable.Range(0, mesh.SideCount / 3)
            .Select(k => TriangleSmoothing.Quality(
                mesh.points[mesh.corners[3 * k]], mesh.points[mesh.corners[3 * k + 1]], mesh.points[mesh.corners[3 * k + 2]])).ToArray();
    }
}
