using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of polygons: areas, centres, insides, bends and simpler outlines.</summary>
    public sealed class PolygonLaws
    {
        private const double k_Bound = 1e-9;

        private static readonly PlanPoint[] s_Square = { new PlanPoint(1, 2), new PlanPoint(4, 2), new PlanPoint(4, 6),
            new PlanPoint(1, 6) };

        [Test]
        public void ARectangle_HasTheAreaAndTheCentreOfItsSides_EitherWayRound()
        {
            PlanPoint[] reversed = s_Square.Reverse().ToArray();

            Assert.That((Polygon.Area(s_Square), Polygon.Area(reversed)), Is.EqualTo((12.0, -12.0)));
            AssertAt(Polygon.Centroid(s_Square), 2.5, 4.0);
            AssertAt(Polygon.Centroid(reversed), 2.5, 4.0);
            AssertAt(Polygon.Centroid(new[] { s_Square[1], s_Square[1], s_Square[1] }), 4.0, 2.0);
        }

        [Test]
        public void AreaAndCentre_AreSumsOverTheParts_WhereverTheyLie()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                var move = new PlanPoint(random.NextFloat(-3f, 3f), random.NextFloat(-3f, 3f));
                var middle = new PlanPoint(0.0, 0.0);
                double area = 0.0, x = 0.0, z = 0.0;
                for (int k = 0; k < star.Length; k++)
                {
                    PlanPoint a = star[k], b = star[(k + 1) % star.Length];
                    double part = 0.5 * (a.x * b.z - a.z * b.x);
                    area += part;
                    x += part * (middle.x + a.x + b.x) / 3.0;
                    z += part * (middle.z + a.z + b.z) / 3.0;
                }

                PlanPoint[] moved = Array.ConvertAll(star, corner => corner + move);
                Assert.That(Polygon.Area(moved), Is.EqualTo(area).Within(k_Bound), $"seed {seed}");
                AssertAt(Polygon.Centroid(moved), x / area + move.x, z / area + move.z);
            }
        }

        [Test]
        public void Inside_IsWhereTheOutlineWindsRound()
        {
            foreach (uint seed in Seeds.First(30))
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                for (int k = 0; k < 40; k++)
                {
                    var point = new PlanPoint(random.NextFloat(-1.2f, 1.2f), random.NextFloat(-1.2f, 1.2f));
                    double turns = 0.0;
                    for (int side = 0; side < star.Length; side++)
                    {
                        PlanPoint a = star[side] - point, b = star[(side + 1) % star.Length] - point;
                        turns += Math.Atan2(PlanPoint.Cross(a, b), PlanPoint.Dot(a, b)) / (2.0 * Math.PI);
                    }

                    Assert.That(Polygon.Contains(star, point), Is.EqualTo(Math.Abs(turns) > 0.5), $"seed {seed}, point {k}");
                }
            }
        }

        [Test]
        public void ASimplePolygon_RunsCounterclockwise_AndCrossesItselfNowhere()
        {
            PlanPoint[] bow = { s_Square[0], s_Square[2], s_Square[1], s_Square[3] };

            Assert.That(Polygon.IsSimple(s_Square), Is.True);
            Assert.That(Polygon.IsSimple(s_Square.Reverse().ToArray()), Is.False);
            Assert.That(Polygon.IsSimple(bow), Is.False);
            Assert.That(Polygon.IsSimple(bow.Reverse().ToArray()), Is.False);
            Assert.That(Polygon.IsSimple(new[] { s_Square[0], s_Square[1] }), Is.False);
            PlanPoint[] pentagram = Array.ConvertAll(
                new[] { 0, 2, 4, 1, 3 }, k => new PlanPoint(Math.Cos(0.4 * Math.PI * k), Math.Sin(0.4 * Math.PI * k)));
            Assert.That(Polygon.IsSimple(pentagram), Is.False, "counterclockwise, but crossed");
            PlanPoint[] knot = { new PlanPoint(0, 0), new PlanPoint(4, 0), new PlanPoint(1, 1), new PlanPoint(3, -0.4) };
            Assert.That(Polygon.Area(knot) > 0.0 && !Polygon.IsSimple(knot), Is.True, "its first side and its third cross");
            Assert.That(Polygon.IsSimple(new[] { s_Square[0], s_Square[1], s_Square[2] }), Is.True, "a triangle");
            foreach (uint seed in Seeds.First(20))
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                Assert.That(Polygon.IsSimple(star), Is.True, $"seed {seed}");
            }
        }

        [Test]
        public void Segments_CrossWhereEachPartsTheEndsOfTheOther()
        {
            PlanPoint a = new PlanPoint(0, 0), b = new PlanPoint(2, 2), c = new PlanPoint(0, 2), d = new PlanPoint(2, 0);

            Assert.That(
                PlanPoint.SegmentsCross(a, b, c, d) && PlanPoint.SegmentsCross(b, a, c, d) && PlanPoint.SegmentsCross(c, d, a, b), Is.True);
            Assert.That(PlanPoint.SegmentsCross(a, b, c, new PlanPoint(0.9, 1.1)), Is.False, "it ends before");
            Assert.That(PlanPoint.SegmentsCross(a, new PlanPoint(0.9, 0.9), c, d), Is.False);
            Assert.That(PlanPoint.SegmentsCross(a, b, new PlanPoint(0, 1), new PlanPoint(2, 3)), Is.False, "parallel");
        }

        [Test]
        public void AUnitVector_IsOneLong_AndOfNothingItIsNothing()
        {
            AssertAt(PlanPoint.Unit(new PlanPoint(-3e-5, 4e-5)), -0.6, 0.8);
            AssertAt(PlanPoint.Unit(new PlanPoint(0.0, -1.05e-12)), 0.0, -1.0);
            AssertAt(PlanPoint.Unit(default), 0.0, 0.0);
        }

        [TestCase(3.0, 5.0, 0.25)]
        [TestCase(-1.0, 0.0, 0.0)]
        [TestCase(99.0, 9.0, 1.0)]
        public void TheClosestPlaceOnASegment_LiesAtItsFoot_OrAtAnEnd(double x, double z, double share)
        {
            PlanPoint a = new PlanPoint(1, 2), b = new PlanPoint(9, 8), foot = a + (b - a) * 0.25;
            PlanPoint p = share == 0.25 ? foot + new PlanPoint(-6, 8) * (x / 10.0) : new PlanPoint(x, z);

            Assert.That(PlanPoint.ClosestOnSegment(p, a, b), Is.EqualTo(share).Within(k_Bound));
            double expected = (a + (b - a) * share - p).LengthSquared;
            Assert.That(PlanPoint.DistanceSquared(p, a, b), Is.EqualTo(expected).Within(k_Bound));
            Assert.That(PlanPoint.DistanceSquared(p, a, a), Is.EqualTo((a - p).LengthSquared).Within(k_Bound), "a segment of one place");
        }

        [Test]
        public void Bounds_HoldAllPoints_AndTheExtentIsTheLongerSide()
        {
            PlanPoint[] points = { new PlanPoint(-2, 3), new PlanPoint(5, -1), new PlanPoint(1, 9), new PlanPoint(0, 0) };
            PlanBounds bounds = new PlanBounds(points), turned = new PlanBounds(Array.ConvertAll(points, p => new PlanPoint(p.z, p.x)));

            Assert.That((bounds.left, bounds.right, bounds.low, bounds.high), Is.EqualTo((-2.0, 5.0, -1.0, 9.0)));
            Assert.That((bounds.Extent, turned.Extent), Is.EqualTo((10.0, 10.0)));
        }

        [Test]
        public void TheLongestDirection_IsThatOfAnEllipse_WhicheverWayItLies()
        {
            for (int degrees = -80; degrees <= 90; degrees += 10)
            {
                double angle = Math.PI * degrees / 180.0, cosine = Math.Cos(angle), sine = Math.Sin(angle);
                var centre = new PlanPoint(5.0, -3.0);
                IEnumerable<PlanPoint> ellipse = Enumerable.Range(0, 36).Select(k =>
                {
                    double x = 3.0 * Math.Cos(Math.PI * k / 18.0), z = Math.Sin(Math.PI * k / 18.0);
                    return centre + new PlanPoint(cosine * x - sine * z, sine * x + cosine * z);
                });
                PlanPoint longest = Polygon.LongestDirection(ellipse, centre);

                Assert.That(Math.Abs(PlanPoint.Cross(longest, new PlanPoint(cosine, sine))), Is.LessThan(k_Bound), $"{degrees} degrees");
                Assert.That(longest.LengthSquared, Is.EqualTo(1.0).Within(k_Bound));
            }
        }

        [Test]
        public void TheTurnAtACorner_HasTheCosineOfItsAngle_WhateverTheSidesLengths()
        {
            for (int degrees = -170; degrees <= 170; degrees += 20)
            {
                double angle = Math.PI * degrees / 180.0;
                PlanPoint[] path = { new PlanPoint(-3.0, 0.0), new PlanPoint(0.0, 0.0),
                    new PlanPoint(0.5 * Math.Cos(angle), 0.5 * Math.Sin(angle)) };
                Assert.That(Polygon.TurnCosine(path, 1), Is.EqualTo(Math.Cos(angle)).Within(k_Bound), $"{degrees} degrees");
            }

            Assert.That(Enumerable.Range(0, 4).Select(corner => Polygon.TurnCosine(s_Square, corner)), Is.All.EqualTo(0.0).Within(k_Bound),
                "the last side joins the first");
        }

        [Test]
        public void ASimplerOutline_IsOfItsCorners_WithinTheTolerance_AndOfTheFewestWhereItIsStraight()
        {
            foreach (uint seed in Seeds.First(30))
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                const double tolerance = 0.15;
                PlanPoint[] simpler = Polygon.Simplified(star, tolerance);
                int at = -1;
                foreach (PlanPoint corner in simpler)
                {
                    int next = Array.FindIndex(star, known => known.x == corner.x && known.z == corner.z);
                    Assert.That(next, Is.GreaterThan(at), $"seed {seed}: in their order");
                    at = next;
                }

                foreach (PlanPoint corner in star)
                    Assert.That(Polyline.Distance(simpler, corner, true), Is.LessThanOrEqualTo(tolerance + k_Bound), $"seed {seed}");
            }

            PlanPoint[] fine = Polyline.Even(s_Square, 140, true);
            PlanPoint[] coarse = Polygon.Simplified(fine, 0.01);
            Assert.That(coarse.Select(corner => (Math.Round(corner.x, 6), Math.Round(corner.z, 6))),
                Is.EquivalentTo(s_Square.Select(corner => (corner.x, corner.z))));
        }

        [Test]
        public void Crossings_GoFromLeftToRight_AndTheInsideLiesBetweenThemInPairs()
        {
            foreach (uint seed in Seeds.First(30))
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                var grid = new PolygonGrid(star);
                var found = new List<double> { 99.0 };
                double z = random.NextFloat(-1.1f, 1.1f);
                grid.FindCrossings(z, found);

                Assert.That(found, Is.Ordered);
                Assert.That(found.Count % 2, Is.Zero);
                for (int k = 0; k <= found.Count; k++)
                {
                    double x = k == 0 ? -2.0 : k == found.Count ? 2.0 : 0.5 * (found[k - 1] + found[k]);
                    Assert.That(Polygon.Contains(star, new PlanPoint(x, z)), Is.EqualTo(k % 2 == 1), $"seed {seed}, stretch {k}");
                }
            }
        }

        [Test]
        public void ARay_MeetsTheNearestSideAhead_ButTheOneItBeginsOn()
        {
            var square = new Polyline(s_Square, true);
            double up = square.RayDistance(new PlanPoint(2, 3), new PlanPoint(0, 1), -1, out int upper),
                right = square.RayDistance(new PlanPoint(2, 3), new PlanPoint(1, 0), -1, out int righter);

            Assert.That((up, upper, right, righter), Is.EqualTo((3.0, 2, 2.0, 1)));
            Assert.That(square.RayDistance(new PlanPoint(2, 1), new PlanPoint(0, 1), -1, out _), Is.EqualTo(1.0), "the nearer of two");
            Assert.That(square.RayDistance(new PlanPoint(2, 1), new PlanPoint(0, 1), 0, out int across), Is.EqualTo(5.0));
            Assert.That(across, Is.EqualTo(2));
            Assert.That(square.RayDistance(new PlanPoint(2, 1), new PlanPoint(0, -1), -1, out int none), Is.EqualTo(double.MaxValue));
            Assert.That(none, Is.EqualTo(-1));
            AssertAt(square.Direction(3), 0.0, -1.0);
        }

        [Test]
        public void Smoothing_FadesAWaveByThePowerOfItsFactor_AndLeavesStraightLinesAndEnds()
        {
            const int count = 24, waves = 3;
            var wave = new PlanPoint[count];
            for (int k = 0; k < count; k++)
                wave[k] = new PlanPoint(Math.Cos(2.0 * Math.PI * waves * k / count), 7.0);
            PlanPoint[] smoothed = Polyline.Smoothed(wave, true);

            // A round with weights 1/4, 1/2, 1/4 multiplies a wave by cos² of half its step.
            double factor = Math.Pow(Math.Cos(Math.PI * waves / count), 8.0);
            for (int k = 0; k < count; k++)
                AssertAt(smoothed[k], factor * wave[k].x, 7.0);
            PlanPoint[] zigzag = { new PlanPoint(0, 0), new PlanPoint(1, 1), new PlanPoint(2, 0), new PlanPoint(3, 1) };
            PlanPoint[] open = Polyline.Smoothed(zigzag);
            AssertAt(open[0], 0.0, 0.0);
            AssertAt(open[3], 3.0, 1.0);
            Assert.That(open[1].x, Is.EqualTo(1.0).Within(k_Bound), "even steps stay");
        }

        private static void AssertAt(PlanPoint point, double x, double z)
        {
            Assert.That(point.x, Is.EqualTo(x).Within(k_Bound));
            Assert.That(point.z, Is.EqualTo(z).Within(k_Bound));
        }

        // Counterclockwise round the origin.
        private static PlanPoint[] Star(ref Random random)
        {
            var star = new PlanPoint[random.NextInt(5, 40)];
            for (int k = 0; k < star.Length; k++)
            {
                double angle = 2.0 * Math.PI * k / star.Length;
                star[k] = new PlanPoint(Math.Cos(angle), Math.Sin(angle)) * random.NextFloat(0.3f, 1f);
            }

            return star;
        }
    }
}
