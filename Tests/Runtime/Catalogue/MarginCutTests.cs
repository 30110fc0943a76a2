using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    public sealed class MarginCutTests
    {
        private const int k_Width = 256;

        private static IEnumerable<WingDefinition> Wings =>
            InsectCatalogue.All.SelectMany(insect => insect.Wings).Where(wing => wing.Pattern != null);

        // Base and tail have the sharpest corners; a wing loses at most a hundredth of its length there, and of its area.
        [TestCaseSource(nameof(Wings))]
        public void AMargin_IsSmooth_JustInsideTheMesh(WingDefinition wing)
        {
            SurfaceMesh surface = wing.CreateSurface(WingSide.Right);
            float scale = (float)wing.Length * InsectDefinition.UnitsPerMetre;
            PlanPoint[] rim = MeshRim.Of(surface.triangles).Single()
                .Select(vertex => new PlanPoint(surface.positions[vertex].x / scale, surface.positions[vertex].z / scale)).ToArray();
            PlanPoint[] curve = wing.Margin.Curve;

            Assert.That(Polygon.Area(curve), Is.EqualTo(Math.Abs(Polygon.Area(rim))).Within(1).Percent);
            double lost = rim.Max(corner => Polyline.Distance(curve, corner, true)), sharpest = 0.0, outside = 0.0;
            foreach (PlanPoint point in curve.Where(point => !Polygon.Contains(rim, point)))
                outside = Math.Max(outside, Polyline.Distance(rim, point, true));
            for (int k = 0; k < curve.Length; k++)
                sharpest = Math.Max(sharpest, Math.Acos(Math.Clamp(Polygon.TurnCosine(curve, k), -1.0, 1.0)));
            TestContext.Progress.WriteLine(
                $"{wing.Name}: {2048 * lost:F1} pixels lost at a corner, {2048 * outside:F2} outside, turns up to {57.3 * sharpest:F1}°");
            Assert.That(2048 * lost, Is.LessThan(20.48));
            Assert.That(2048 * outside, Is.LessThan(2.0));
            Assert.That(57.3 * sharpest, Is.LessThan(22.0), "the sharpest corner, between two pieces of the curve");
        }

        [TestCaseSource(nameof(Wings))]
        public void APicture_IsOpaqueWithin_ClearBeyond_AndHalfOfBothOnTheMargin(WingDefinition wing)
        {
            double depth = wing.Contour.Front - wing.Contour.Rear;
            int height = (int)Math.Round(k_Width * depth);
            Color32[] plain = wing.Pattern.Paint(wing.Contour, k_Width, height), cut = wing.Paint(k_Width, height);
            double area = 0.0;
            for (int k = 0; k < cut.Length; k++)
            {
                double span = (k % k_Width + 0.5) / k_Width, forward = wing.Contour.Rear + (k / k_Width + 0.5) * depth / height;
                Assert.That((cut[k].r, cut[k].g, cut[k].b), Is.EqualTo((plain[k].r, plain[k].g, plain[k].b)), "the colours go on");
                double away = Polyline.Distance(wing.Margin.Curve, new PlanPoint(span, forward), true) * k_Width;
                if (away > 1.0)
                    Assert.That(cut[k].a, Is.EqualTo(wing.Margin.Contains(span, forward) ? plain[k].a : 0), $"{span}, {forward}");
                area += plain[k].a > 0 ? cut[k].a / (double)plain[k].a : 0.0;
            }

            Assert.That(area * depth / (k_Width * (double)height), Is.EqualTo(Polygon.Area(wing.Margin.Curve)).Within(1).Percent);
        }

        [Test]
        public void APicture_IsGlass_Cut_OrSolid()
        {
            foreach (WingDefinition wing in Wings)
            {
                bool isGlass = wing.Pattern is MembranePattern || wing.Pattern is FinPattern;
                foreach (int width in new[] { 64, 512 })
                {
                    int height = (int)(width * (wing.Contour.Front - wing.Contour.Rear));
                    Assert.That(PictureOpacities.Of(wing.Paint(width, height), width),
                        Is.EqualTo(isGlass ? PictureOpacity.Clear : PictureOpacity.Cut), wing.Name);
                }
            }

            var opaque = new Color32(9, 9, 9, 255);
            var half = new Color32(9, 9, 9, 128);
            Color32 none = default;
            Assert.That(PictureOpacities.Of(Pixels(opaque, opaque, opaque, opaque), 2), Is.EqualTo(PictureOpacity.Solid));
            Assert.That(PictureOpacities.Of(Pixels(opaque, none, opaque, none), 2), Is.EqualTo(PictureOpacity.Cut));
            Assert.That(PictureOpacities.Of(Pixels(opaque, half, none, opaque), 2), Is.EqualTo(PictureOpacity.Cut), "a blurred edge");
            var pane = new Color32[15 * 15];
            Array.Fill(pane, half);
            Assert.That(PictureOpacities.Of(pane, 15), Is.EqualTo(PictureOpacity.Clear));
            Array.Fill(pane, opaque);
            (pane[0], pane[7 * 15 + 7], pane[8 * 15 + 7], pane[8 * 15 + 8]) = (none, half, half, half);
            Assert.That(PictureOpacities.Of(pane, 15), Is.EqualTo(PictureOpacity.Clear), "a window");
        }

        private static Color32[] Pixels(params Color32[] pixels) => pixels;
    }
}
