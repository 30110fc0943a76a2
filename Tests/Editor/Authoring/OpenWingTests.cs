using System;
using System.Collections.Generic;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Wings whose drawn margin does not close: by a gap beside dark cells, or as the picture cuts their base off.</summary>
    public sealed class OpenWingTests
    {
        private static readonly Color32 s_Black = new Color32(0, 0, 0, 255), s_White = new Color32(255, 255, 255, 255);

        // Dark cells along the leading edge are no whole wing, though they are thick.
        [Test]
        public void AGapInTheMargin_IsClosed_ThoughPartOfTheWingIsDark()
        {
            WingPlace place = DrawnWing.Monarch().In(400);
            DrawnPicture picture = place.Draw(DrawnKind.Drawing);
            List<Vector2> dark = Above(place.Outline, 150f);
            picture.Fill(dark, s_Black);
            Vector2 gap = Lowest(place.Outline);
            picture.Stroke(new[] { gap, gap + new Vector2(2f, 0f) }, 5f, s_White);

            double whole = Math.Abs(Polygon.Area(PlanPaths.ToPlan(place.Outline)));
            double darkShare = Math.Abs(Polygon.Area(PlanPaths.ToPlan(dark.ToArray()))) / whole;
            Assert.That(darkShare, Is.GreaterThan(0.1).And.LessThan(0.5), "a part of it");
            Assert.That(Area(picture.ToPicture()) / whole, Is.EqualTo(1.0).Within(0.03));
        }

        // The rim lies halfway between ground and what is darkest nearby: beside a vein that reaches the margin, that is no rim.
        [Test]
        public void APaleMembrane_HasNoSlitsAlongItsDarkVeins()
        {
            WingPlace place = DrawnWing.Monarch().In(400);
            DrawnPicture picture = new DrawnPicture(400, 400, s_White).Fill(place.Outline, new Color32(215, 210, 200, 255));
            foreach (float angle in new[] { -0.5f, -0.2f, 0.1f, 0.3f })
            {
                picture.Stroke(
                    new[] { place.At(Vector2.zero), place.At(new Vector2(2f * Mathf.Cos(angle), 2f * Mathf.Sin(angle))) }, 5f, s_Black);
            }

            // What lies outside is ground again.
            DrawnPicture ground = new DrawnPicture(400, 400, s_White).Fill(place.Outline, s_Black);
            Color32[] wing = picture.ToPixels(), mask = ground.ToPixels();
            for (int k = 0; k < wing.Length; k++)
                wing[k] = mask[k].r < 128 ? wing[k] : s_White;
            PlanPoint[] outline = Outline(new WingPicture(400, 400, wing));

            Assert.That(PlanPaths.Hausdorff(outline, PlanPaths.ToPlan(place.Outline)), Is.LessThan(0.03 * place.Length));
        }

        // Narrow cells between veins that come together, beside a base that is drawn without a margin.
        [Test]
        public void CellsBetweenVeinsThatMeet_BelongToTheWing_ThoughItsBaseIsOpen()
        {
            WingPlace place = DrawnWing.Fan().In(1200);
            DrawnPicture picture = new DrawnPicture(1200, 1200, s_White).Fill(place.Outline, new Color32(200, 191, 168, 255));
            picture.Stroke(place.Outline, 6f, s_Black);
            for (int k = 10; k < place.Outline.Length - 10; k += 12)
                picture.Stroke(new[] { place.At(Vector2.zero), place.Outline[k] }, 6f, s_Black);

            Assert.That(
                PlanPaths.Hausdorff(Outline(picture.ToPicture()), PlanPaths.ToPlan(place.Outline)), Is.LessThan(0.02 * place.Length));
        }

        // Shadows are no membranes beside a vein: narrower.
        [Test]
        public void PatchesOfShadowBesideTheWing_StayOutside()
        {
            WingPlace place = DrawnWing.Monarch().In(400);
            var grey = new Color32(225, 225, 225, 255);
            DrawnPicture picture = new DrawnPicture(400, 400, s_White).Fill(place.Outline, s_Black);
            Vector2 low = Lowest(place.Outline) + new Vector2(0f, 4f);
            for (int k = -3; k <= 3; k++)
                picture.Stroke(new[] { low + new Vector2(9f * k, 0f), low + new Vector2(9f * k + 4f, 0f) }, 3f, grey);

            Assert.That(PlanPaths.Hausdorff(Outline(picture.ToPicture()), PlanPaths.ToPlan(place.Outline)), Is.LessThan(3.0), "pixels");
        }

        [TestCase(5, 20, false, ExpectedResult = true)]
        [TestCase(0, 27, false, ExpectedResult = false)]
        [TestCase(5, 20, true, ExpectedResult = false)]
        public bool ACut_IsClosed_UpToNineTenthsOfASide_ButNotOfAFrame(int from, int to, bool isFrame)
        {
            var mask = new PixelMask(40, 30);
            for (int column = 0; column < 20; column++)
                mask[column, from] = mask[column, to] = true;
            for (int row = from; row <= to; row++)
                mask[19, row] = true;
            for (int k = 0; isFrame && k < 30; k++)
                mask[19, k] = true;

            PixelMask closed = CutWing.Closed(mask);
            Assert.That(mask[0, (from + to) / 2], Is.False, "the mask that was given stays");
            return closed[0, (from + to) / 2];
        }

        [Test]
        public void CellsThatRunOutOfThePicture_BelongToTheWing([Values(0, 90, 180, 270)] int degrees)
        {
            WingPlace place = DrawnWing.Fan().In(400);
            DrawnPicture picture = place.Draw(DrawnKind.Drawing);
            Vector2 hinge = place.At(Vector2.zero);
            foreach (float angle in new[] { -0.6f, -0.2f, 0.2f })
                picture.Stroke(new[] { hinge, place.At(new Vector2(0.9f * Mathf.Cos(angle), 0.9f * Mathf.Sin(angle))) }, 2f, s_Black);
            int cut = (int)(hinge.x + 0.4f * place.Length);
            double rest = Math.Abs(Polygon.Area(PlanPaths.ToPlan(RightOf(place.Outline, cut).ToArray())));

            Assert.That(Area(Turned(picture, cut, degrees / 90)) / rest, Is.EqualTo(1.0).Within(0.03));
        }

        [Test]
        public void AnEdgeThatIsNowhereClear_IsNoWing()
        {
            DrawnPicture picture = new DrawnPicture(300, 300, s_White)
                .Shade((x, y) => -90f * Mathf.Max(0f, 1f - 2.2f * new Vector2(x - 0.5f, y - 0.5f).magnitude));

            FormatException problem =
                Assert.Throws<FormatException>(() => WingTracer.Trace(picture.ToPicture(), WingTracingSettings.Default));

            Assert.That(problem.Message, Does.Match("^No wing was found: .* a faint edge on \\d+ % of its outline"));
        }

        private static double Area(WingPicture picture) => Math.Abs(Polygon.Area(Outline(picture)));

        private static PlanPoint[] Outline(WingPicture picture)
        {
            var working = new WorkingPicture(picture);
            return OutlineFinder.Find(WingSeparation.Of(working), working.Factor);
        }

        // The picture from a column on, turned by right angles.
        private static WingPicture Turned(DrawnPicture picture, int from, int quarters)
        {
            Color32[] pixels = picture.ToPixels();
            int wide = picture.width - from, high = picture.height;
            var turned = new Color32[wide * high];
            for (int row = 0; row < high; row++)
            {
                for (int column = 0; column < wide; column++)
                {
                    int x = column, y = row, width = wide, height = high;
                    for (int k = 0; k < quarters; k++)
                    {
                        (x, y) = (height - 1 - y, x);
                        (width, height) = (height, width);
                    }

                    turned[y * width + x] = pixels[row * picture.width + column + from];
                }
            }

            return quarters % 2 == 0 ? new WingPicture(wide, high, turned) : new WingPicture(high, wide, turned);
        }

        private static Vector2 Lowest(Vector2[] outline)
        {
            Vector2 lowest = outline[0];
            foreach (Vector2 point in outline)
                lowest = point.y > lowest.y ? point : lowest;
            return lowest;
        }

        private static List<Vector2> Above(Vector2[] outline, float row) => Clipped(outline, point => row - point.y);

        private static List<Vector2> RightOf(Vector2[] outline, float column) => Clipped(outline, point => point.x - column);

        // The part of a polygon where a linear function is positive.
        private static List<Vector2> Clipped(Vector2[] polygon, Func<Vector2, float> inside)
        {
            var part = new List<Vector2>();
            for (int k = 0, before = polygon.Length - 1; k < polygon.Length; before = k++)
            {
                float a = inside(polygon[before]), b = inside(polygon[k]);
                if (a * b < 0f)
                    part.Add(Vector2.Lerp(polygon[before], polygon[k], a / (a - b)));
                if (b >= 0f)
                    part.Add(polygon[k]);
            }

            return part;
        }
    }
}
