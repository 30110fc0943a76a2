using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Margins whose hollows, edges and tails are made to measure.</summary>
    public sealed class MarginLaws
    {
        private const double k_Width = 0.14;

        [TestCase(0.31, 9)]
        [TestCase(0.34, 8)]
        public void HollowsOfAFan_AreAlikeUpToFourTimesTheWidth(double last, int rays)
        {
            // All are as deep for their width, so that their rims are as long for it too.
            double[] widths = Enumerable.Repeat(0.08, 7).Append(last).ToArray();

            Assert.That(Rays(widths, width => 0.3 * width, out _), Has.Count.EqualTo(rays));
        }

        [TestCase(0.39)]
        [TestCase(0.42)]
        public void AHollowOfAFan_IsNoWiderThanFourTenths(double last)
        {
            double[] widths = Enumerable.Repeat(0.2, 7).Append(last).ToArray();
            List<double> ends = Rays(widths, width => 0.15 * width, out double end);

            Assert.That(ends, Has.Count.EqualTo(9));
            Assert.That(end - ends[8], last < 0.4 ? Is.EqualTo(0.0).Within(0.003) : Is.GreaterThan(0.01), "the thread is held there");
        }

        [TestCase(0.0, 11)]
        [TestCase(0.28, 11)]
        [TestCase(0.33, 8)]
        [TestCase(0.68, 8)]
        [TestCase(0.72, 12)]
        [TestCase(1.27, 12)]
        [TestCase(1.34, 8)]
        public void AGapOfAFan_IsNarrow_OrAsWideAsAHollow(double gap, int rays)
        {
            // A gap that is as wide as a hollow, within three tenths, is a hollow without depth.
            double rim = Hollow(k_Width, 0.0, 0.12 * k_Width).Sum;
            double[] widths = Enumerable.Repeat(k_Width, 7).Append(-gap * rim).Concat(Enumerable.Repeat(k_Width, 3)).ToArray();
            List<double> ends = Rays(widths.Where(width => width != 0.0).ToArray(), width => 0.12 * width, out _);

            Assert.That(ends, Has.Count.EqualTo(rays));
            Assert.That(ends, Is.Ordered);
            if (rays == 12)
                Assert.That(ends[8] - ends[7], Is.EqualTo(gap * rim).Within(0.1 * rim), "the gap itself");
        }

        [TestCase(0.45, true)]
        [TestCase(0.54, false)]
        public void AFan_BeginsHalfAHollowBehindTheTipAtMost(double behind, bool isFan)
        {
            // The first hollow begins behind the tip by this share of its rim.
            double rim = Hollow(k_Width, 0.0, 0.12 * k_Width).Sum;
            double[] widths = Enumerable.Repeat(k_Width, 8).Prepend(-0.2).ToArray();
            List<double> ends = Rays(widths, width => 0.12 * width, out _, 0.2 - behind * rim);

            Assert.That(ends, Has.Count.EqualTo(isFan ? 9 : 0));
        }

        [TestCase(0.0027, true)]
        [TestCase(0.0032, false)]
        public void ALineAlongAnEdge_MayLieThreeThousandthsOutside(double depth, bool isStraight)
        {
            // The lower edge is bowed in by the depth.
            var outline = new ClosedCurve(
                new[] { new PlanPoint(0, 0), new PlanPoint(0, 1), new PlanPoint(2, 1), new PlanPoint(2, 0), new PlanPoint(1, depth) },
                16000);
            List<PlanPoint> path = InnerPath.Find(outline, outline.Nearest(new PlanPoint(2, 0)), outline.Nearest(default));

            Assert.That(path.Count == 2, Is.EqualTo(isStraight));
            Assert.That(Math.Sqrt((path[0] - new PlanPoint(2, 0)).LengthSquared + path[path.Count - 1].LengthSquared), Is.LessThan(1e-3));
        }

        [TestCase(0.53, true)]
        [TestCase(0.60, false)]
        public void ATail_HasLessThanAnEighthOfTheWing_OrBeginsFartherOut(double length, bool isWhole)
        {
            // A strip of 0.12 on the rear of a wing of 1 by 1/2: 0.12 of all where it is 0.568 long.
            PlanPoint[] corners =
            {
                new PlanPoint(0, 0), new PlanPoint(0, 0.25), new PlanPoint(1, 0.25), new PlanPoint(1, -0.25), new PlanPoint(0.56, -0.25),
                new PlanPoint(0.56, -0.25 - length), new PlanPoint(0.44, -0.25 - length), new PlanPoint(0.44, -0.25),
                new PlanPoint(0, -0.25),
            };
            var outline = new ClosedCurve(corners, 1600);
            var trimmed = new TrimmedOutline(outline, 0.25, outline.Length - 0.25);

            Assert.That(trimmed.Tails, Has.Count.EqualTo(1));
            Assert.That(outline.At(trimmed.Tails[0].from).z, isWhole ? Is.EqualTo(-0.25).Within(0.01) : Is.LessThan(-0.265));
        }

        [TestCase(0.0)]
        [TestCase(0.06)]
        [TestCase(-0.06)]
        public void TheLastChain_EndsWhereTheRearIsDeepest_ButDrawnToItsMiddle(double slope)
        {
            // Straight from under the tip to the base: deeper by the slope, less 0.07 at a quarter of the way from the middle.
            double rear = -0.2 - slope;
            PlanPoint from = new PlanPoint(1.0, -0.2), to = new PlanPoint(0.0, rear);
            var outline = new ClosedCurve(new[] { new PlanPoint(0, 0), new PlanPoint(0, 0.15), new PlanPoint(1, 0.15), from, to }, 8000);
            var marks = new WingLandmarks(outline, new FitNotes());
            var axis = PlanPoint.Unit(Polygon.Centroid(outline.Samples) - marks.Base);
            double deeper = PlanPoint.Dot(PlanPoint.Unit(to - from), new PlanPoint(axis.z, -axis.x)),
                whole = marks.TrailingRoot - marks.Tip, quarter = 0.25 * whole;

            Assert.That((outline.At(marks.Tip) - new PlanPoint(1, 0.15)).LengthSquared, Is.LessThan(1e-4));
            Assert.That(marks.Last - marks.Tip, Is.EqualTo(0.5 * whole + deeper * quarter * quarter / (2.0 * 0.07)).Within(2e-3));
        }

        [Test]
        public void APlaceFromAbove_IsLiftedToTheSurface_OrToItsNearestRim()
        {
            // A roof: up along x to the middle, and down.
            float3[] points = { new float3(-1, 0, 0), new float3(-1, 0, 2), new float3(0, 1, 2), new float3(0, 1, 0), new float3(3, 0, 0),
                new float3(3, 0, 2) };
            var triangles = new List<int3> { new int3(0, 1, 2), new int3(0, 2, 3), new int3(3, 2, 5), new int3(3, 5, 4) };
            var sheet = new WingSheet(points, triangles, WingPlane.Facing(new float3(0f, 1f, 0f)), 1e-5f);
            void AssertLifted(float3 from, float3 wanted) =>
                Assert.That(math.distance(sheet.Lift(sheet.plane.ToPlan(from)), wanted), Is.LessThan(1e-5f), $"{from}");

            AssertLifted(new float3(-0.5f, 9f, 0.7f), new float3(-0.5f, 0.5f, 0.7f));
            AssertLifted(new float3(1.5f, -4f, 1.2f), new float3(1.5f, 0.5f, 1.2f));
            AssertLifted(new float3(5f, 0f, 0.4f), new float3(3f, 0f, 0.4f));
            AssertLifted(new float3(0f, 0f, -1f), new float3(0f, 1f, 0f));
            AssertLifted(new float3(-2f, 0f, 3f), new float3(-1f, 0f, 2f));
            Assert.That(sheet.PlanArea, Is.EqualTo(8.0).Within(1e-6));
            Assert.That(sheet.Area, Is.EqualTo(2.0 * Math.Sqrt(2.0) + 2.0 * Math.Sqrt(10.0)).Within(1e-5));
            Assert.That(sheet.OutlineShare, Is.EqualTo(1.0).Within(1e-6));
        }

        // Hollows of these widths side by side on a circle of radius 1; a negative width is that length of the circle itself.
        private static List<double> Rays(double[] widths, Func<double, double> depth, out double end, double tip = 0.0)
        {
            double angle = widths.Sum(width => width > 0.0 ? Turn(width) : -width) * 0.5;
            var corners = new List<PlanPoint> { default, new PlanPoint(0.0, 0.1) };
            corners.Add(On(angle, 1.0));
            foreach (double width in widths)
            {
                if (width > 0.0)
                    corners.AddRange(Hollow(width, angle, depth(width)).Points.Skip(1));
                else
                    corners.AddRange(Enumerable.Range(1, 20).Select(k => On(angle + width * k / 20.0, 1.0)));
                angle -= width > 0.0 ? Turn(width) : -width;
            }

            corners.Add(new PlanPoint(0.0, -0.1));
            var outline = new ClosedCurve(corners, 4000);
            end = outline.Nearest(corners[corners.Count - 2]);
            return MarginRays.Find(outline, 0.02, outline.Length - 0.02, outline.Nearest(corners[2]) + tip);
        }

        // The chord of a hollow, with half a wave of its depth inwards of it.
        private static (List<PlanPoint> Points, double Sum) Hollow(double width, double angle, double depth)
        {
            PlanPoint from = On(angle, 1.0), to = On(angle - Turn(width), 1.0), inward = PlanPoint.Unit((from + to) * -1.0);
            var points = Enumerable.Range(0, 25)
                .Select(k => from + (to - from) * (k / 24.0) + inward * (depth * Math.Sin(Math.PI * k / 24.0))).ToList();
            return (points, Polyline.LengthOf(points));
        }

        private static double Turn(double width) => 2.0 * Math.Asin(0.5 * width);

        private static PlanPoint On(double angle, double radius) => new PlanPoint(radius * Math.Cos(angle), radius * Math.Sin(angle));
    }
}
