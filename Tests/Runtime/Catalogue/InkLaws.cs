using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>Laws of tints, soft shapes, veins and margins that wings and bodies are drawn with.</summary>
    public sealed class InkLaws
    {
        // A plate of length 1: leading edge at 0.1, trailing edge at -0.3.
        private static WingOutline Plate() =>
            WingOutline.FromMillimetres(new[] { 0.0, 25.0, 50.0 }, new[] { 5.0, 5.0, 5.0 }, new[] { -15.0, -15.0, -15.0 });

        [TestCase(0f, 10, 200, 90, 255)]
        [TestCase(1f, 110, 0, 90, 55)]
        [TestCase(0.25f, 35, 150, 90, 205)]
        [TestCase(-3f, 10, 200, 90, 255)]
        [TestCase(7f, 110, 0, 90, 55)]
        public void AMix_GoesFromOneColourToTheOther_ChannelByChannel(float share, int red, int green, int blue, int alpha) => Assert.That(
            Tint.Mix(new Color32(10, 200, 90, 255), new Color32(110, 0, 90, 55), share),
            Is.EqualTo(new Color32((byte)red, (byte)green, (byte)blue, (byte)alpha)));

        [TestCase(0.9f, 1f)]
        [TestCase(1.5f, 0.75f)]
        [TestCase(2f, 0.5f)]
        [TestCase(2.5f, 0.25f)]
        [TestCase(3.1f, 0f)]
        public void SoftSteps_FallFromOneToNought_OverTheirWidth_AboutTheLimit(float at, float share)
        {
            Assert.That(Tint.Below(at, 2f, 2f), Is.EqualTo(share).Within(1e-6f));
            Assert.That(Ink.Within(at, 2.0, 2.0), Is.EqualTo(share).Within(1e-6f));
            Assert.That(Tint.Spot(new Vector3(1f, 2f + at, 3f), new Vector3(1f, 2f, 3f), 2f, 2f), Is.EqualTo(share).Within(1e-6f));
            Assert.That(Ink.Between(at, -7.0, 2.0, 2.0), Is.EqualTo(share).Within(1e-6f));
            Assert.That(Ink.Between(-at, -2.0, 7.0, 2.0), Is.EqualTo(share).Within(1e-6f));
        }

        [Test]
        public void Grain_IsEvenlySpread()
        {
            float[] grains =
                Enumerable.Range(0, 4000).Select(k => Ink.Speckle(new Vector3(k % 20, k / 20 % 20, k / 400) * 0.37f)).ToArray();

            Assert.That(grains, Is.All.GreaterThanOrEqualTo(0f).And.All.LessThanOrEqualTo(1f));
            Assert.That(grains.Average(), Is.EqualTo(0.5f).Within(0.03f));
            for (int tenth = 0; tenth < 10; tenth++)
                Assert.That(grains.Count(grain => (int)(10f * grain) == tenth), Is.InRange(300, 500));
        }

        [Test]
        public void AnEllipse_IsHalfDrawnOnItsRim_AndRowsRepeatIt()
        {
            for (int k = 0; k < 12; k++)
            {
                double x = 3.0 * Math.Cos(0.5 * k), z = 2.0 * Math.Sin(0.5 * k);
                Assert.That(Ink.Ellipse(x, z, 3.0, 2.0, 0.1), Is.EqualTo(0.5f).Within(1e-5f));
                Assert.That(Ink.Ellipse(0.9 * x, 0.9 * z, 3.0, 2.0, 0.1), Is.EqualTo(1f));
                Assert.That(Ink.Ellipse(1.1 * x, 1.1 * z, 3.0, 2.0, 0.1), Is.EqualTo(0f));
                foreach (int spot in new[] { -2, 0, 5 })
                {
                    Assert.That(Ink.Row(10.0 * (spot + 0.5) + x, 4.0 + z, 10.0, 4.0, 3.0, 2.0, 0.1), Is.EqualTo(0.5f).Within(1e-5f),
                        "middles half a spacing on");
                }
            }
        }

        [Test]
        public void EdgesAndMargins_AreTracedFromEndToEnd_AndExtendedStraight()
        {
            List<double> edge = Ink.Edge(span => 2.0 * span, 0.25, 0.75), margin = Ink.Margin(Plate(), 0.0, 1.0),
                extended = Ink.Extended(new List<double> { 0, 0, 3, 4, 3, 6 }, 5.0);

            Assert.That((edge[0], edge[1], edge[edge.Count - 2], edge[edge.Count - 1]), Is.EqualTo((0.25, 0.5, 0.75, 1.5)));
            Assert.That(new[] { margin[0], margin[1], margin[margin.Count - 2], margin[margin.Count - 1] },
                Is.EqualTo(new[] { 0.0, 0.1, 0.0, -0.3 }).Within(1e-6), "from the leading to the trailing corner of the base");
            Assert.That(extended, Is.EqualTo(new[] { -3.0, -4.0, 0.0, 0.0, 3.0, 4.0, 3.0, 6.0, 3.0, 11.0 }).Within(1e-9));
        }

        [Test]
        public void Strokes_CountTheWayAlongThem_AndAreDrawnAsWideAsAsked()
        {
            StrokeSet set = new StrokeSet().Add(new[] { 0.0, 0.0, 3.0, 0.0, 3.0, 4.0 }, 10.0);

            Assert.That(set.Distance(4.0, 2.0, out double along), Is.EqualTo(1.0));
            Assert.That(along, Is.EqualTo(15.0));
            Assert.That(set.Line(1.0, 0.5, 0.5, 0.2), Is.EqualTo(0.5f).Within(1e-6f), "half drawn at half its width");
            Assert.That(set.Line(1.0, 0.39, 0.5, 0.2), Is.EqualTo(1f));
            Assert.That(set.Line(1.0, 0.61, 0.5, 0.2), Is.EqualTo(0f));
        }

        [Test]
        public void Veins_RunFromEvenRootsToTheirSharesOfTheMargin_AndBendTowardsTheLeadingEdge()
        {
            // Around the plate the margin is 1 + 0.4 + 1 long: half of it is the middle of the tip, 0.1 and 0.9 lie on the edges.
            VeinFan straight = new VeinFan(Plate(), 0.0).Add(0.1, 0.5, 0.9), gathered = new VeinFan(Plate(), 1.0).Add(0.5);
            for (int vein = 0; vein < 3; vein++)
                Assert.That(straight.Distance(0.0, 0.1 - 0.4 * (vein + 0.5) / 3.0, out _), Is.LessThan(1e-6), $"root {vein}");
            Assert.That(straight.Distance(0.24, 0.1, out double first), Is.LessThan(1e-4));
            Assert.That(straight.Distance(1.0, -0.1, out double tip), Is.LessThan(1e-4));
            Assert.That(straight.Distance(0.24, -0.3, out _), Is.LessThan(1e-4));
            Assert.That(first, Is.GreaterThan(0.2));
            Assert.That(tip, Is.EqualTo(1.0).Within(1e-3), "a straight vein is as long as the plate");
            Assert.That(straight.Distance(0.5, -0.1, out _), Is.LessThan(1e-6), "no gathering runs straight");

            // A curve of second order is half way to its bend in the middle: at the leading edge over half of the tip's span.
            Assert.That(gathered.Distance(0.5, 0.0, out _), Is.LessThan(1e-3));
            Assert.That(straight.Veins(0.5, -0.1 + 0.01, 0.01, 0.002), Is.EqualTo(0.5f).Within(0.01f), "half widths");
        }

        [Test]
        public void CrossVeins_JoinAVeinToTheNearestPlaceOfTheNext_AndForksLeaveTheirVein()
        {
            VeinFan fan = new VeinFan(Plate(), 0.0).Add(0.5 - 0.05, 0.5 + 0.05).Cross(0, 0.5);
            VeinFan forked = new VeinFan(Plate(), 0.0).Add(0.5).Fork(0, 0.5, 0.75);

            Assert.That(fan.CrossVeins(0.5, -0.1, 0.01, 0.002), Is.EqualTo(1f), "half way between two veins");
            Assert.That(fan.CrossVeins(0.6, -0.1, 0.01, 0.002), Is.EqualTo(0f));
            Assert.That(forked.Distance(0.6, -0.3, out double along), Is.LessThan(1e-4), "a tip at three quarters of the margin");
            Assert.That(along, Is.GreaterThan(0.5), "counted on from the place where it leaves");
        }

        [Test]
        public void AMembranesVeins_AreWidestOnTheWayOut_AndItsColoursAreTheirs()
        {
            VeinFan veins = new VeinFan(Plate(), 0.0).Add(0.5);
            var pattern = new MembranePattern(Plate(), veins)
            {
                Membrane = new Color(0.1f, 0.2f, 0.3f, 0.4f),
                Base = new Color(0.5f, 0.6f, 0.7f, 0.8f),
                Vein = new Color(0.9f, 0.05f, 0.15f, 1f),
                VeinHalfWidth = 0.02,
            };
            double Width(double span)
            {
                double width = 0.0;
                for (double z = 0.0; z < 0.05; z += 1e-4)
                    width = pattern.ColourAt(span, -0.1 + z, 1e-5).a > 0.9f ? z : width;
                return width;
            }

            // A share of 0.45 at the root, which grows by 2.5 and then falls by 0.6 of the way.
            Assert.That(Width(0.05), Is.EqualTo(0.02 * (0.45 + 2.5 * 0.05)).Within(2e-4));
            Assert.That(Width(0.5), Is.EqualTo(0.02 * 0.7).Within(2e-4));
            Assert.That(Width(0.8), Is.EqualTo(0.02 * 0.52).Within(2e-4));
            Color far = pattern.ColourAt(0.7, -0.2, 1e-5), near = pattern.ColourAt(0.0, -0.02, 1e-5),
                vein = pattern.ColourAt(0.5, -0.1, 1e-5);
            Assert.That(((Color32)far, (Color32)vein), Is.EqualTo(((Color32)pattern.Membrane, (Color32)pattern.Vein)));
            Assert.That(near.r, Is.GreaterThan(0.45f), "the colour near the base");
        }

        [Test]
        public void Vertices_HaveTheColoursOfTheirPlaces_WhateverTheWingsLength()
        {
            var pattern = new Coordinates();
            var surface = new SurfaceMesh { positions = new[] { new Vector3(0.03f, 0f, -0.01f), new Vector3(0.06f, 0f, 0.02f) } };
            Color32[] colours = pattern.ColourVertices(surface, 0.1f, 0.25);

            Assert.That(colours[0], Is.EqualTo((Color32)new Color(0.3f, 0.4f, 0.25f, 1f)));
            Assert.That(colours[1], Is.EqualTo((Color32)new Color(0.6f, 0.7f, 0.25f, 1f)));
        }

        [Test]
        public void Scallops_AreAsDeepAsAsked_BetweenPointsThatStay()
        {
            var margin = new Polyline(new[] { new PlanPoint(0, 0), new PlanPoint(10, 0) });
            List<Polyline> cut = new RimScallops(0.2, 0.8, 0.5, 0.25, 0.0).Cut(margin);

            Assert.That(cut.Select(part => (Math.Round(part.Points[0].x, 9), Math.Round(part.Points[part.Points.Count - 1].x, 9))),
                Is.EqualTo(new[] { (0.0, 2.0), (2.0, 4.0), (4.0, 6.0), (6.0, 8.0), (8.0, 10.0) }));
            double[] depths = cut.Select(part => part.Points.Max(point => Math.Abs(point.z))).ToArray();
            Assert.That(depths, Is.EqualTo(new[] { 0.0, 0.5, 0.25, 0.0, 0.0 }).Within(1e-6));
            Assert.That(cut[1].Points.Min(point => point.z), Is.EqualTo(-0.5).Within(1e-6), "inwards: the margin runs clockwise");
        }

        private sealed class Coordinates : WingPattern
        {
            public override Color ColourAt(double span, double forward, double softness) =>
                new Color((float)span, (float)(0.5 + forward), (float)softness, 1f);
        }
    }
}
