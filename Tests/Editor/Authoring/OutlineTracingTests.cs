using System;
using System.Collections.Generic;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>The outline found in a picture against the one that was drawn.</summary>
    public sealed class OutlineTracingTests
    {
        private const double k_Bound = 0.015;

        private static IEnumerable<TestCaseData> Some => Cases(isQuick: true);

        private static IEnumerable<TestCaseData> Others => Cases(isQuick: false);

        // Quickly: a few wings, each of another kind.
        private static IEnumerable<TestCaseData> Cases(bool isQuick)
        {
            int count = 0;
            foreach (DrawnWing wing in DrawnWing.All)
            {
                foreach (DrawnKind kind in Enum.GetValues(typeof(DrawnKind)))
                {
                    foreach (int side in kind == DrawnKind.Hard || kind == DrawnKind.Drawing ? new[] { 200, 600 } : new[] { 200 })
                    {
                        if (count++ % 17 == 0 == isQuick)
                            yield return new TestCaseData(wing.Name, kind, side);
                    }
                }
            }
        }

        [TestCaseSource(nameof(Some))]
        public void Outline_IsFoundWithinOnePointFivePercentOfSpan(string name, DrawnKind kind, int side) => AssertFound(name, kind, side);

        [TestCaseSource(nameof(Others))]
        [Explicit]
        [Category("Long")]
        public void AnyOtherOutline_IsFoundWithinOnePointFivePercentOfSpan(string name, DrawnKind kind, int side) =>
            AssertFound(name, kind, side);

        [TestCase("monarch", DrawnKind.Hard, Explicit = true, Category = "Long")]
        [TestCase("tailed", DrawnKind.Gradient, Explicit = true, Category = "Long")]
        [TestCase("fan", DrawnKind.Drawing, Explicit = true, Category = "Long")]
        public void OutlineInALargePicture_IsFoundWithinOnePointFivePercentOfSpan(string name, DrawnKind kind) =>
            AssertFound(name, kind, 2000);

        [Test]
        public void OutlineOfASilhouette_IsFoundWithinATenthOfAPixelOfItsArea()
        {
            WingPlace place = DrawnWing.Monarch().In(300);

            PlanPoint[] outline = Trace(place.Draw(DrawnKind.Silhouette));

            double truth = Polygon.Area(PlanPaths.Counterclockwise(place.Outline));
            Assert.That(Polygon.Area(outline), Is.EqualTo(truth).Within(0.1 * Polyline.LengthOf(outline, true)));
        }

        // A long ellipse, whose sides lie beside chords by up to the tolerance.
        [TestCase(300, 0.25)]
        [TestCase(1300, 0.65)]
        public void AnOutline_LiesBesideTheRim_ByNoMoreThanAQuarterOfAPixel_OrHalfAThousandthOfTheLength(int length, double tolerance)
        {
            var ellipse = new Vector2[2000];
            for (int k = 0; k < ellipse.Length; k++)
            {
                double angle = 2.0 * Math.PI * k / ellipse.Length;
                ellipse[k] = V(0.5f * length * (1f + (float)Math.Cos(angle)) + 20f, 45f + 25f * (float)Math.Sin(angle));
            }

            DrawnPicture picture = new DrawnPicture(length + 40, 90, new Color32(255, 255, 255, 255))
                .Fill(ellipse, new Color32(0, 0, 0, 255));
            var wing = WingSeparation.Of(new WorkingPicture(picture.ToPicture()));
            PlanPoint[] outline = OutlineFinder.Find(wing, 1);
            double farthest = 0.0;
            foreach (Vector2 place in ellipse)
            {
                if (Math.Abs(place.x - 20f - 0.5f * length) < 0.4f * length)
                    farthest = Math.Max(farthest, Polyline.Distance(outline, new PlanPoint(place.x, -place.y), true));
            }

            Assert.That(farthest, Is.InRange(0.5 * tolerance, tolerance + 0.1));

            // Each pixel of a picture that was made smaller counts for as many.
            PlanPoint[] larger = OutlineFinder.Find(wing, 3);
            Assert.That(larger.Length, Is.EqualTo(outline.Length));
            for (int k = 0; k < outline.Length; k++)
                Assert.That((larger[k] - outline[k] * 3.0).LengthSquared, Is.LessThan(1e-12));
        }

        [Test]
        public void BlackWingOnTransparentBlack_IsToldByItsAlphaAlone()
        {
            WingPlace place = DrawnWing.Scalloped().In(300);
            var picture = new DrawnPicture(300, 300, new UnityEngine.Color32(0, 0, 0, 0));

            PlanPoint[] outline = Trace(picture.Fill(place.Outline, new UnityEngine.Color32(0, 0, 0, 255)));

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(k_Bound * place.Length));
        }

        [Test]
        public void OutlineDrawnWithGaps_IsClosed()
        {
            WingPlace place = DrawnWing.Monarch().In(400);
            DrawnPicture picture = place.Draw(DrawnKind.Drawing);
            var white = new UnityEngine.Color32(255, 255, 255, 255);
            foreach (int at in new[] { 100, 300, 500, 700 })
                picture.Stroke(new[] { place.Outline[at], place.Outline[at] + new UnityEngine.Vector2(2f, 1f) }, 4f, white);

            PlanPoint[] outline = Trace(picture);

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(k_Bound * place.Length));
        }

        [Test]
        public void DashedOutline_IsClosed_ThoughVeinsMeetInAKnot()
        {
            WingPlace place = DrawnWing.Fan().In(600);
            var black = new UnityEngine.Color32(0, 0, 0, 255);
            var picture = new DrawnPicture(600, 600, new UnityEngine.Color32(255, 255, 255, 255));
            var rim = new Polyline(PlanPaths.ToPlan(place.Outline), true);
            int dashes = (int)(rim.Length / 30.0);
            for (int k = 0; k < dashes; k++)
            {
                double from = rim.Length * k / dashes;
                picture.Stroke(
                    Array.ConvertAll(new[] { from, from + 8.0, from + 16.0, from + 22.0 }, at => ToPicture(rim.At(at))), 3f, black);
            }

            foreach (float angle in new[] { -0.9f, -0.5f, -0.1f, 0.2f, 0.5f })
            {
                picture.Stroke(
                    place.At(new[] { V(0.02f, 0f), V(0.85f * (float)Math.Cos(angle), 0.85f * (float)Math.Sin(angle)) }), 3f, black);
            }

            PlanPoint[] outline = Trace(picture);

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(k_Bound * place.Length));
        }

        [Test]
        public void LineAroundThePicture_IsPassedOver()
        {
            WingPlace place = DrawnWing.Scalloped().In(320);
            var black = new UnityEngine.Color32(0, 0, 0, 255);
            Vector2[] frame = new[] { V(1, 1), V(319, 1), V(319, 319), V(1, 319), V(1, 1) };

            PlanPoint[] outline = Trace(place.Draw(DrawnKind.Drawing).Stroke(frame, 1.5f, black));

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(k_Bound * place.Length));
        }

        [Test]
        public void SpecksBesideTheWing_ArePassedOver()
        {
            WingPlace place = DrawnWing.Fan().In(400);
            DrawnPicture picture = place.Draw(DrawnKind.Silhouette);
            for (int k = 0; k < 6; k++)
                picture.Stroke(new[] { V(10 + 9 * k, 12), V(12 + 9 * k, 18) }, 3f, new UnityEngine.Color32(0, 0, 0, 255));

            PlanPoint[] outline = Trace(picture);

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(k_Bound * place.Length));
        }

        private static void AssertFound(string name, DrawnKind kind, int side)
        {
            WingPlace place = Find(name).In(side, side == 600 ? 25f : 0f, kind == DrawnKind.Hard);

            PlanPoint[] outline = Trace(place.Draw(kind));

            Assert.That(Polygon.Area(outline), Is.GreaterThan(0.0), "counterclockwise");
            double distance = PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline));
            Assert.That(distance / place.Length, Is.LessThan(k_Bound));
        }

        private static DrawnWing Find(string name)
        {
            foreach (DrawnWing wing in DrawnWing.All)
            {
                if (wing.Name == name)
                    return wing;
            }

            throw new ArgumentException(name);
        }

        private static PlanPoint[] Trace(DrawnPicture picture)
        {
            var working = new WorkingPicture(picture.ToPicture());
            return OutlineFinder.Find(WingSeparation.Of(working), working.Factor);
        }

        private static UnityEngine.Vector2 ToPicture(PlanPoint place) => V((float)place.x, (float)-place.z);

        private static UnityEngine.Vector2 V(float x, float y) => new UnityEngine.Vector2(x, y);
    }
}
