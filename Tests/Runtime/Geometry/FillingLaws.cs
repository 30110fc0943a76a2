using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of filled outlines: vertices of the rim, vertices inside, Delaunay's condition.</summary>
    public sealed class FillingLaws
    {
        private static readonly PlanPoint[] s_Square = Square(0.0, 4.0);

        [Test]
        public void Triangles_ObeyDelaunaysCondition_ByTheCirclesThroughTheirCorners()
        {
            foreach (uint seed in Seeds.First(15))
            {
                PlanPoint[] points = Scattered(seed, 60);
                TriangleLinks mesh = DelaunayTriangulation.Inside(points, 4);
                double area = 0.0;
                for (int side = 0; side < mesh.SideCount; side += 3)
                {
                    PlanPoint a = points[mesh.corners[side]], b = points[mesh.corners[side + 1]], c = points[mesh.corners[side + 2]];
                    double doubled = Polygon.DoubledArea(a, b, c);
                    area += 0.5 * doubled;
                    Assert.That(doubled, Is.GreaterThan(0.0), $"seed {seed}: counterclockwise");

                    // The centre lies as far from all three corners.
                    PlanPoint ab = b - a, ac = c - a;
                    PlanPoint centre = a + new PlanPoint(ac.z * ab.LengthSquared - ab.z * ac.LengthSquared, ab.x * ac.LengthSquared
                        - ac.x * ab.LengthSquared) * (0.5 / doubled);
                    double radius = Math.Sqrt((a - centre).LengthSquared);
                    Assert.That(points.Min(point => Math.Sqrt((point - centre).LengthSquared)), Is.GreaterThan(radius * (1.0 - 1e-6)),
                        $"seed {seed}");
                }

                Assert.That(area, Is.EqualTo(16.0).Within(1e-9), $"seed {seed}: the square is filled");
                Assert.That(mesh.SideCount, Is.EqualTo(3 * (2 * 60 + 4 - 2)), $"seed {seed}");
            }
        }

        [Test]
        public void SidesAndTwins_NameEachOther_AndOnlyTheRimHasNone()
        {
            PlanPoint[] points = Scattered(3u, 30);
            TriangleLinks mesh = DelaunayTriangulation.Inside(points, 4);
            int rim = 0;
            for (int side = 0; side < mesh.SideCount; side++)
            {
                int twin = mesh.twins[side];
                if (mesh.corners[side] >= 4)
                {
                    Assert.That(
                        mesh.Find(mesh.corners[side], mesh.End(side)), Is.EqualTo(side), "around an inner point all sides are found");
                }
                Assert.That(mesh.corners[mesh.firstSides[mesh.corners[side]]], Is.EqualTo(mesh.corners[side]));
                if (twin < 0)
                {
                    rim++;
                    Assert.That(mesh.End(side), Is.EqualTo((mesh.corners[side] + 1) % 4), "counterclockwise along the rim");
                    continue;
                }

                Assert.That((mesh.twins[twin], mesh.corners[twin], mesh.End(twin)), Is.EqualTo((side, mesh.End(side), mesh.corners[side])));
            }

            Assert.That(rim, Is.EqualTo(4));
            int[] clockwise = mesh.Clockwise();
            for (int k = 0; k < clockwise.Length; k += 3)
                Assert.That(mesh.Area(clockwise[k], clockwise[k + 1], clockwise[k + 2]), Is.LessThan(0.0));
        }

        [Test]
        public void PointsInside_AreAsManyAsWanted_ClearOfTheRimAndOfCorners_AndEven([Values(7, 60, 400)] int count)
        {
            List<PlanPoint> rim = Polyline.Even(s_Square, 4 * (int)Math.Ceiling(Math.Sqrt(count)), true).ToList(),
                corners = s_Square.ToList();
            List<PlanPoint> inside = InteriorPoints.Place(rim, corners, count);
            double even = Math.Sqrt(2.0 / Math.Sqrt(3.0) * 16.0 / count), nearest = double.MaxValue;
            for (int a = 0; a < inside.Count; a++)
            {
                for (int b = 0; b < a; b++)
                    nearest = Math.Min(nearest, Math.Sqrt((inside[a] - inside[b]).LengthSquared));
            }

            Assert.That(inside, Has.Count.EqualTo(count));
            Assert.That(nearest, Is.InRange(0.5 * even, 1.1 * even), "a lattice of equal triangles");
            Assert.That(inside.Min(point => Polyline.Distance(rim, point, true)), Is.GreaterThan(0.54 * nearest));
            Assert.That(
                inside.Min(point => corners.Min(corner => Math.Sqrt((corner - point).LengthSquared))), Is.GreaterThan(1.09 * nearest));
            Assert.That(inside.All(point => Polygon.Contains(rim, point)), Is.True);
            PlanPoint middle = inside.Aggregate((a, b) => a + b) * (1.0 / count);
            Assert.That(Math.Sqrt((middle - new PlanPoint(2, 2)).LengthSquared), Is.LessThan(even), "all over the square");
            Assert.That(InteriorPoints.Place(rim, corners, 0), Is.Empty);
        }

        [Test]
        public void ARimsVertices_AreItsCorners_AndEvenBetween_InTheNumberThatIsAsked([Values] bool isOdd)
        {
            PlanPoint[] fine = Polyline.Even(s_Square, 160, true);
            List<PlanPoint> found = RimSampler.Sample(fine, 0.5, isOdd, null),
                given = RimSampler.Sample(fine, 0.5, isOdd, new[] { 0, 40, 80, 120 });
            foreach (List<PlanPoint> rim in new[] { found, given })
            {
                Assert.That(rim.Count % 2, Is.EqualTo(isOdd ? 1 : 0));
                Assert.That(rim.Count, Is.InRange(32, 33));
                foreach (PlanPoint corner in s_Square)
                    Assert.That(rim.Min(point => Math.Sqrt((point - corner).LengthSquared)), Is.LessThan(1e-9), "corners are vertices");
                for (int k = 0; k < rim.Count; k++)
                    Assert.That(Math.Sqrt((rim[(k + 1) % rim.Count] - rim[k]).LengthSquared), Is.InRange(0.44, 0.51), $"side {k}");
                Assert.That(Polygon.IsSimple(rim), Is.True);
            }
        }

        [TestCase(20.0, false, false, 4)]
        [TestCase(20.0, false, true, 3)]
        [TestCase(40.0, true, true, 3)]
        public void ARimOfOneOrTwoVertices_GetsThreeOrFour(double even, bool fromOneCorner, bool isOdd, int count)
        {
            // A circle of radius 1, on which a spacing of 4 or 8 leaves one vertex for each of its corners.
            PlanPoint[] circle = Enumerable.Range(0, 60).Select(k => new PlanPoint(Math.Cos(Math.PI * k / 30), Math.Sin(Math.PI * k / 30)))
                .ToArray();
            List<PlanPoint> rim = RimSampler.Sample(circle, even, isOdd, fromOneCorner ? new[] { 7 } : null);

            Assert.That(rim, Has.Count.EqualTo(count));
            Assert.That(Polygon.IsSimple(rim), Is.True);
        }

        [Test]
        public void AStarsRim_IsForcedIn_HoweverItsCornersAreOrdered()
        {
            foreach (uint seed in Seeds.First(150))
            {
                var random = new Random(seed);
                var star = new PlanPoint[random.NextInt(5, 14)];
                int turn = random.NextInt(star.Length);
                for (int k = 0; k < star.Length; k++)
                {
                    double angle = 2.0 * Math.PI * (k + 0.3 * random.NextDouble()) / star.Length;
                    star[(k + turn) % star.Length] = new PlanPoint(Math.Cos(angle), Math.Sin(angle)) * random.NextFloat(0.15f, 1f);
                }

                TriangleLinks mesh = DelaunayTriangulation.Inside(star, star.Length);
                double area = 0.0;
                for (int side = 0; side < mesh.SideCount; side += 3)
                    area += 0.5 * mesh.Area(mesh.corners[side], mesh.corners[side + 1], mesh.corners[side + 2]);
                Assert.That(mesh.SideCount, Is.EqualTo(3 * (star.Length - 2)), $"seed {seed}");
                Assert.That(area, Is.EqualTo(Polygon.Area(star)).Within(1e-9), $"seed {seed}");
                for (int side = 0; side < mesh.SideCount; side++)
                {
                    Assert.That(mesh.IsAgainstDelaunay(side) && mesh.CanFlip(side), Is.False, $"seed {seed}, side {side}");
                    if (mesh.twins[side] < 0)
                        Assert.That(mesh.End(side), Is.EqualTo((mesh.corners[side] + 1) % star.Length), $"seed {seed}");
                }
            }
        }

        [Test]
        public void WhereAnOutlineIsNarrow_ItsVerticesLieCloser_ButNotWithoutEnd_AndChangeSlowly()
        {
            // Four wide and 0.4 wide; a strip of 0.05 would ask for less than the least.
            var strip = new Polyline(
                new[] { new PlanPoint(0, 0), new PlanPoint(20, 0), new PlanPoint(20, 0.4), new PlanPoint(0, 0.4) }, true);
            var hair = new Polyline(
                new[] { new PlanPoint(0, 0), new PlanPoint(20, 0), new PlanPoint(20, 0.05), new PlanPoint(0, 0.05) }, true);
            var wide = new Polyline(new[] { new PlanPoint(0, 0), new PlanPoint(20, 0), new PlanPoint(20, 9), new PlanPoint(0, 9) }, true);

            Assert.That(2.0 / new RimSpacing(strip, 1.0).Count(9.0, 11.0), Is.EqualTo(0.36).Within(1e-9), "0.9 of the width");
            Assert.That(
                2.0 / new RimSpacing(hair, 1.0).Count(9.0, 11.0), Is.EqualTo(0.2).Within(1e-9), "a fifth of the even spacing at least");
            Assert.That(2.0 / new RimSpacing(wide, 1.0).Count(9.0, 11.0), Is.EqualTo(1.0).Within(1e-9));

            // A funnel: widths of 0.1 on the left, of 6 on the right.
            var funnel = new Polyline(new[] { new PlanPoint(0, 0), new PlanPoint(6, 0), new PlanPoint(6, 3), new PlanPoint(12, 3),
                new PlanPoint(12, -3), new PlanPoint(6, -3), new PlanPoint(6, -0.1), new PlanPoint(0, -0.1) }.Reverse().ToArray(), true);
            var spacing = new RimSpacing(funnel, 1.0);
            double least = 9.0, most = 0.0;
            const double step = 0.1;
            for (double at = 0.0; at < funnel.Length; at += step)
            {
                double here = 0.02 / spacing.Count(at, at + 0.02), next = 0.02 / spacing.Count(at + step, at + step + 0.02);
                Assert.That(Math.Abs(next - here), Is.LessThanOrEqualTo(0.4 * (step + 0.26)), $"at {at}");
                (least, most) = (Math.Min(least, here), Math.Max(most, here));
            }

            Assert.That(least, Is.EqualTo(0.2).Within(1e-6));
            Assert.That(most, Is.EqualTo(1.0).Within(1e-6));
        }

        [Test]
        public void Advancing_IsTheInverseOfCounting_AlsoAroundTheEnd()
        {
            var strip = new Polyline(
                new[] { new PlanPoint(0, 0), new PlanPoint(20, 0), new PlanPoint(20, 3), new PlanPoint(0, 0.4) }, true);
            var spacing = new RimSpacing(strip, 1.0);
            var random = new Random(4u);
            for (int k = 0; k < 50; k++)
            {
                double from = random.NextDouble() * strip.Length, by = 30.0 * random.NextDouble();
                Assert.That(spacing.Count(from, spacing.Advance(from, by)), Is.EqualTo(by).Within(1e-6), $"from {from} by {by}");
            }
        }

        [Test]
        public void AMesh_HasTheTrianglesThatAreAsked_AndNotAllOfItsCornersOnTheRim()
        {
            PlanPoint[] strip = { new PlanPoint(0, 0), new PlanPoint(9, 0), new PlanPoint(9, 0.7), new PlanPoint(0, 0.5) };
            for (int triangles = 30; triangles < 90; triangles += 13)
            {
                TriangleLinks mesh = OutlineMesher.Mesh(strip, triangles, out int rim);
                double area = Enumerable.Range(0, triangles)
                    .Sum(k => 0.5 * mesh.Area(mesh.corners[3 * k], mesh.corners[3 * k + 1], mesh.corners[3 * k + 2]));

                Assert.That(mesh.SideCount, Is.EqualTo(3 * triangles));
                Assert.That(rim, Is.LessThanOrEqualTo(0.8 * (triangles + 2)), $"{triangles} triangles");
                Assert.That(2 * (mesh.points.Length - rim) + rim - 2, Is.EqualTo(triangles), "Euler's formula");
                Assert.That(area, Is.EqualTo(Polygon.Area(mesh.points.Take(rim).ToArray())).Within(1e-9));
                Assert.That(area, Is.InRange(0.9 * 5.4, 1.001 * 5.4));
            }
        }

        [Test]
        public void TooFewTriangles_AreRefused_WithTheirNumber()
        {
            PlanPoint[] comb = Comb(12);

            Assert.That(() => OutlineMesher.Mesh(comb, 3, out _), Throws.ArgumentException.With.Message.Contains("with 3 triangles"));
        }

        private static PlanPoint[] Comb(int teeth)
        {
            var comb = new List<PlanPoint> { new PlanPoint(2.0 * teeth, 0.0), new PlanPoint(2.0 * teeth, 1.0) };
            for (int tooth = teeth - 1; tooth >= 0; tooth--)
            {
                comb.AddRange(new[] { new PlanPoint(2.0 * tooth + 1.5, 1.0), new PlanPoint(2.0 * tooth + 1.5, 9.0),
                    new PlanPoint(2.0 * tooth + 0.5, 9.0), new PlanPoint(2.0 * tooth + 0.5, 1.0) });
            }
            comb.AddRange(new[] { new PlanPoint(0.0, 1.0), new PlanPoint(0.0, 0.0) });
            return comb.ToArray();
        }

        private static PlanPoint[] Square(double from, double to) =>
            new[] { new PlanPoint(from, from), new PlanPoint(to, from), new PlanPoint(to, to), new PlanPoint(from, to) };

        private static PlanPoint[] Scattered(uint seed, int count)
        {
            var random = new Random(seed);
            List<PlanPoint> points = s_Square.ToList();
            for (int k = 0; k < count; k++)
                points.Add(new PlanPoint(0.05 + 3.9 * random.NextDouble(), 0.05 + 3.9 * random.NextDouble()));
            return points.ToArray();
        }
    }
}
