using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Fitting;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Places on outlines of few corners, whose base, tip and neck can be said beforehand; and rays from such a base.</summary>
    public sealed class LandmarkLaws
    {
        private const int k_Samples = 8000;

        [Test]
        public void TheBase_IsWhatLiesNextToTheAnchor_ButNoWiderThanAThirdOfTheReach()
        {
            // From the anchor up a straight inner side, round a rectangle and back.
            ClosedCurve narrow = Curve((0, 0), (0, 0.1), (1, 0.1), (1, -0.15), (0, -0.15)),
                wide = Curve((0, 0), (0, 0.5), (1, 0.5), (1, -0.4), (0, -0.4));
            WingLandmarks few = Marks(narrow), many = Marks(wide);

            Assert.That(few.LeadingRoot, Is.EqualTo(0.105).Within(2e-4), "0.005 round the corner");
            Assert.That(few.TrailingRoot, Is.EqualTo(narrow.Length - 0.155).Within(2e-4));
            AssertAt(few.Base, 0.005, -0.025, 3e-4);
            Assert.That(many.LeadingRoot, Is.EqualTo(0.35).Within(2e-4));
            Assert.That(many.TrailingRoot, Is.EqualTo(wide.Length).Within(2e-4), "0.35 between both ends");
            AssertAt(many.Base, 0.0, 0.175, 3e-4);
        }

        [TestCase(1.44, true)]
        [TestCase(1.475, false)]
        public void TheTip_IsTheLeadingCorner_UntilTheOtherIsFartherThanTheSpiralBetweenThem(double farther, bool leads)
        {
            // The spiral ln r + 0.36 angle = const grows by exp(0.36 · π/3) = 1.458 over 60 degrees.
            const double near = 0.6;
            double half = Math.Sqrt(0.75);
            ClosedCurve wing = Curve(
                (0, 0), (0, 0.004), (near * half, near * 0.5), (near * farther * half, -near * farther * 0.5), (0, -0.004));
            PlanPoint tip = wing.At(Marks(wing).Tip);

            Assert.That(tip.z, leads ? Is.EqualTo(0.5 * near).Within(0.02) : Is.EqualTo(-0.5 * near * farther).Within(0.02));
        }

        [TestCase(0.245, false)]
        [TestCase(0.275, true)]
        public void ATip_IsUnclear_WhereItsFlatTopIsLong(double length, bool isUnclear)
        {
            // Along one spiral all places are as good: an even spread has the standard deviation of its length over the root of 12.
            const double spiral = 0.36;
            var corners = new List<(double, double)> { (0, 0), (0, 0.004) };
            double turn = length / Math.Sqrt(1.0 + spiral * spiral);
            for (int k = 0; k <= 100; k++)
            {
                double angle = turn * (0.5 - k / 100.0), r = Math.Exp(-spiral * angle);
                corners.Add((r * Math.Cos(angle), r * Math.Sin(angle)));
            }
            corners.Add((0, -0.004));
            var notes = new FitNotes();
            var marks = new WingLandmarks(Curve(corners.ToArray()), notes);

            Assert.That(notes.Warned(SkeletonFitWarningKind.TipUnclear), Is.EqualTo(isUnclear));
            Assert.That(notes.Confidence, Is.EqualTo(isUnclear ? 0.075 * Math.Sqrt(12.0) / length : 1.0).Within(0.04));
            if (isUnclear)
                Assert.That(notes.Warnings[0].ToString(), Does.Contain("somewhere within 16 % of its length"));
            Assert.That(marks.Rays, Is.Empty);
        }

        [TestCase(1.28, true)]
        [TestCase(1.32, false)]
        public void TheLastChain_ReachesNoFartherThan130PercentOfTheFirst(double share, bool isInReach)
        {
            ClosedCurve wing = Curve((0, 0), (0, 0.1), (1, 0.1), (1, -0.15), (0, -0.15));
            WingLandmarks marks = Marks(wing);
            PlanPoint first = wing.At(marks.Tip) - marks.Base;

            Assert.That(marks.IsLastInReach(marks.Base + new PlanPoint(first.z, -first.x) * share), Is.EqualTo(isInReach));
        }

        [TestCase(0.0285, false)]
        [TestCase(0.0315, true)]
        public void ALeadingEdge_HasANeck_WhereItDrawsInByThreeHundredths(double depth, bool isFound)
        {
            (double, double) neck = (0.75, 0.2 - depth);
            ClosedCurve wing = Curve((0, 0.2), (0.5, 0.2), neck, (1, 0.2), (1, 0.15), (0.75, 0.15 - depth), (0.5, -0.3), (0, -0.3));

            Assert.That(TryFind(wing, (1, 0.2), out OutlineStretch tail), Is.EqualTo(isFound));
            if (!isFound)
                return;
            AssertAt(wing.At(tail.from), 0.75, 0.2 - depth, 2e-3);
            double width = Math.Sqrt((wing.At(tail.to) - wing.At(tail.from)).LengthSquared);
            Assert.That(wing.At(tail.to).z, Is.LessThan(0.2 - depth), "across the tail");
            Assert.That(width, Is.LessThan(0.0501));
        }

        // Behind a shoulder the leading edge drops to a strip: the wing without it is 0.325 and 0.05 of the strip's width.
        [TestCase(0.2, 0.18, true)]
        [TestCase(0.2, 0.19, false)]
        [TestCase(0.55, 0.1, true)]
        [TestCase(0.61, 0.1, false)]
        public void BeyondANeck_LiesATail_WhereTheNeckIsHalfTheMeanChord_AndTheTailAnEighthOfTheWing(
            double length, double width, bool isFound)
        {
            double end = 0.7 + length;
            ClosedCurve wing = Curve(
                (0, 0.25), (0.6, 0.25), (0.7, 0.05), (end, 0.05), (end, 0.05 - width), (0.7, 0.05 - width), (0.6, -0.25), (0, -0.25));

            Assert.That(TryFind(wing, (end, 0.05), out OutlineStretch tail), Is.EqualTo(isFound));
            if (isFound)
                AssertAt(wing.At(tail.from), 0.7, 0.05, 2e-3);
        }

        [TestCase(0, 1.0, 0.0)]
        [TestCase(1, 0.5, 0.0)]
        [TestCase(2, 0.0, 0.0)]
        [TestCase(3, 0.0, 0.06)]
        [TestCase(5, 0.0, 0.18)]
        public void Rays_FanAtEvenAngles_FromRootsEverCloser_ThenEverDeeper(int attempt, double spread, double depth)
        {
            ClosedCurve wing = Fan(60.0, 1.25);
            WingLandmarks marks = Marks(wing);
            const int count = 5;
            PlanPoint[][] rays = RayChains.Lay(wing, marks, count, 4, attempt);
            PlanPoint from = marks.Base + PlanPoint.Unit(Polygon.Centroid(wing.Samples) - marks.Base) * depth,
                front = wing.At(marks.LeadingRoot), rear = wing.At(marks.TrailingRoot);
            double turn = Clockwise(wing.At(marks.Tip) - from, wing.At(marks.Last) - from), first = 0.0;
            int cut = 0;
            for (int k = 0; k < count; k++)
            {
                PlanPoint root = rays[k][0], end = rays[k][3], way = end - from;
                PlanPoint place = (front + (rear - front) * (k / 4.0) - marks.Base) * spread + from;
                AssertAt(root, place.x, place.z, 1e-9);
                AssertAt(rays[k][1], root.x + (end.x - root.x) / 3.0, root.z + (end.z - root.z) / 3.0, 1e-9);
                Assert.That(Clockwise(wing.At(marks.Tip) - from, way), Is.EqualTo(turn * k / 4.0).Within(1e-6), $"ray {k}");
                double length = Math.Sqrt(way.LengthSquared);
                first = k == 0 ? length : first;
                bool isCut = Math.Abs(length - 1.2 * first) < 1e-9;
                cut += isCut ? 1 : 0;
                Assert.That(length, Is.LessThanOrEqualTo(1.2 * first + 1e-9));
                if (!isCut)
                    Assert.That(Polyline.Distance(wing.Samples, from + way * (1.0 / 0.99), true), Is.LessThan(1e-6), "a hundredth inside");
            }

            Assert.That(cut, Is.GreaterThan(0), "the rear reaches farther");
            PlanPoint middle = RayChains.Middle(rays), sum = rays.Aggregate(default(PlanPoint), (all, ray) => all + ray[3] - ray[0]);
            Assert.That(PlanPoint.Cross(middle, sum), Is.Zero.Within(1e-9));
            Assert.That(middle.LengthSquared, Is.EqualTo(1.0).Within(1e-9));
        }

        [Test]
        public void RaysOfASlenderWing_FanOverSixTenthsOfARadian()
        {
            ClosedCurve wing = Fan(10.0, 1.0);
            PlanPoint[][] rays = RayChains.Lay(wing, Marks(wing), 3, 3, 2);

            Assert.That(Clockwise(rays[0][2] - rays[0][0], rays[2][2] - rays[0][0]), Is.EqualTo(0.6).Within(1e-6));
        }

        [TestCase(0.082f, true)]
        [TestCase(0.090f, false)]
        public void OfAStraightInnerSide_TheFrontIsTheBase_UpToATiltOfTenDegrees(float slant, bool isFront)
        {
            // The body lies towards −X; the side from (0, −¼) to (slant, ¼) faces it where tan 0.17 = 0.1717 is twice the slant.
            var surface = new SurfaceMesh
            {
                positions = new[] { new Vector3(0f, 0f, -0.25f), new Vector3(slant, 0f, 0.25f), new Vector3(1f, 0f, 0.25f),
                    new Vector3(1f, 0f, -0.25f) },
                triangles = new[] { 0, 1, 2, 0, 2, 3 },
            };
            var notes = new FitNotes();
            var unit = new UnitSurface(surface);
            WingSheet sheet = new SheetReader("Mesh", unit, Vector3.up, notes).Read();
            var outline = new ClosedCurve(sheet.outline, 1600);
            SkeletonFitSettings settings = SkeletonFitSettings.Default;
            settings.bodySide = 2f * Vector3.left;
            settings.forward = 3f * new Vector3(0.4f, 0.2f, 1f);
            double anchor = new BaseFinder(outline, sheet, unit, notes).Find(settings);

            Assert.That(sheet.plane.Direction(outline.At(anchor)).z, isFront ? Is.Positive : Is.Negative);
            Assert.That(notes.Warnings, Is.Empty);
        }

        private static bool TryFind(ClosedCurve wing, (double X, double Z) tip, out OutlineStretch tail)
        {
            var rear = new PlanPoint(0.0, wing.Samples.Min(place => place.z));
            return TipNeck.TryFind(wing, 0.0, wing.Nearest(new PlanPoint(tip.X, tip.Z)), wing.Nearest(rear), out tail);
        }

        // A sector on a narrow base, whose radius grows from 1 in front to what is said behind.
        private static ClosedCurve Fan(double degrees, double rear)
        {
            var corners = new List<(double, double)> { (0, 0), (0, 0.05) };
            for (int k = 0; k <= 100; k++)
            {
                double angle = Math.PI / 180.0 * degrees * (1.0 - k / 50.0), r = 1.0 + (rear - 1.0) * k / 100.0;
                corners.Add((r * Math.Cos(angle), r * Math.Sin(angle)));
            }
            corners.Add((0, -0.05));
            return Curve(corners.ToArray());
        }

        private static WingLandmarks Marks(ClosedCurve outline) => new WingLandmarks(outline, new FitNotes());

        private static ClosedCurve Curve(params (double X, double Z)[] corners) =>
            new ClosedCurve(Array.ConvertAll(corners, corner => new PlanPoint(corner.X, corner.Z)), k_Samples);

        private static double Clockwise(PlanPoint from, PlanPoint to) =>
            Math.Atan2(PlanPoint.Cross(to, from), PlanPoint.Dot(from, to));

        private static void AssertAt(PlanPoint point, double x, double z, double within)
        {
            Assert.That(point.x, Is.EqualTo(x).Within(within));
            Assert.That(point.z, Is.EqualTo(z).Within(within));
        }
    }
}
