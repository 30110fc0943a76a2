using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Authoring;
using Alate.Geometry;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of veins: the response of lines, their widths, gaps and order, against closed forms.</summary>
    public sealed class VeinLaws
    {
        [TestCase(-60f, 2.0, 0f)]
        [TestCase(60f, 2.0, 0f)]
        [TestCase(-60f, 1.2, 35f)]
        [TestCase(60f, 4.0, 90f)]
        public void TheResponseOfALine_IsThatOfABell_WhicheverWayItRuns_DarkOrBright(float contrast, double width, float degrees)
        {
            // Across a line A exp(−x² / 2 s²), blurred by a bell of width w, the curvature is A s (s² + w²)^(−3/2); times w², and the most
            // over the three widths that are tried.
            const int side = 120;
            double cosine = Math.Cos(degrees * Math.PI / 180.0), sine = Math.Sin(degrees * Math.PI / 180.0), wanted = 0.0;
            WorkingPicture picture = Painted(
                side, (x, y) => 120.0 + contrast * Math.Exp(-0.5 * Math.Pow(((x - 60.0) * cosine + (y - 60.0) * sine) / width, 2.0)));
            PixelPlane field = RidgeField.Of(picture, Whole(side), 400.0);
            foreach (double bell in new[] { 1.0, 1.8, 3.2 })
                wanted = Math.Max(wanted, bell * bell * Math.Abs(contrast) * width * Math.Pow(width * width + bell * bell, -1.5));

            Assert.That(field[60, 60], Is.EqualTo(wanted).Within(0.12 * wanted), "up to the steps of pixels");
            Assert.That(field[60 + (int)Math.Round(12.0 * cosine), 60 + (int)Math.Round(12.0 * sine)], Is.LessThan(0.05 * wanted),
                "beside the line");
            Assert.That(field[60 - (int)Math.Round(12.0 * sine), 60 + (int)Math.Round(12.0 * cosine)],
                Is.EqualTo(wanted).Within(0.12 * wanted), "along the line");
        }

        [Test]
        public void Spots_AreNoLines()
        {
            WorkingPicture picture = Painted(
                80, (x, y) => 120.0 - 80.0 * Math.Exp(-0.5 * ((x - 40.0) * (x - 40.0) + (y - 40.0) * (y - 40.0)) / 9.0));

            Assert.That(RidgeField.Of(picture, Whole(80), 300.0)[40, 40], Is.EqualTo(0f).Within(0.5f), "curved along as across");
        }

        [Test]
        public void Shades_AreThoseThatTheEyeSees_AndGoOnBeyondTheWing()
        {
            const int side = 60;
            var pixels = new Color32[side * side];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = k % side < 30 ? new Color32(200, 100, 50, 255) : new Color32(255, 255, 255, 255);
            var wing = new PixelMask(side, side);
            for (int k = 0; k < pixels.Length; k++)
                wing[k % side, k / side] = k % side < 30;
            PixelPlane shades = RidgeField.Shades(new WorkingPicture(new WingPicture(side, side, pixels)), wing);
            float grey = 0.299f * 200f + 0.587f * 100f + 0.114f * 50f;

            Assert.That(shades[10, 30], Is.EqualTo(grey).Within(1e-3f));
            Assert.That(shades[29, 30], Is.EqualTo(grey).Within(1e-2f), "pixels of the rim are mixed with ground");
            Assert.That(shades[34, 30], Is.EqualTo(grey).Within(1e-2f), "the wing's own shades go on");
        }

        [TestCase(1.0)]
        [TestCase(2.0)]
        public void AVeinsWidth_IsWhatItDarkensOverTheStrongestContrast_InWingLengths(double factor)
        {
            // Lines of 4, 1 and 0.5 pixels in a row of chains on a plane of 300 by 120; all as dark, as far as pixels show them.
            const int width = 300, height = 120;
            var shades = new PixelPlane(width, height);
            double[] rows = { 30.0, 60.0, 90.0 }, widths = { 4.0, 1.0, 0.5 };
            for (int k = 0; k < shades.values.Length; k++)
            {
                double shade = 200.0;
                for (int line = 0; line < 3; line++)
                {
                    shade -= 90.0 * Math.Max(0.0,
                        Math.Min(k / width + 1.0, rows[line] + 0.5 * widths[line]) - Math.Max(k / width, rows[line] - 0.5 * widths[line]));
                }
                shades.values[k] = (float)shade;
            }

            double length = 400.0;
            var chains = new PlanPoint[4][];
            var veins = new RadialVein[4];
            for (int line = 0; line < 3; line++)
            {
                chains[line + 1] = Enumerable.Range(0, 5)
                    .Select(j => new PlanPoint((20.0 + 60.0 * j) * factor, -rows[line] * factor)).ToArray();
                veins[line + 1] = new RadialVein(Polyline.Even(chains[line + 1], 200), 0.0, 1.0);
            }

            chains[0] = chains[1];
            float[][] found = new VeinWidths(shades, factor, length * factor).Measure(chains, veins);
            for (int line = 0; line < 3; line++)
                Assert.That(found[line + 1], Is.All.EqualTo(widths[line] / length).Within(0.02 * widths[line] / length), $"line {line}");
            Assert.That(found[0], Is.EqualTo(new[] { found[1].Max() }), "the leading edge without a vein has the largest width");
            veins[1] = null;
            Assert.That(new VeinWidths(shades, factor, length * factor).Measure(chains, veins)[1], Is.Null);
        }

        [TestCase(0.065, true)]
        [TestCase(0.075, false)]
        public void AGapStraightAhead_IsBridged_UpToSevenHundredthsOfTheWing(double share, bool isBridged)
        {
            const double length = 200.0;
            int gap = (int)(share * length), end = 60;
            var thin = new PixelMask(140, 20);
            for (int x = 10; x < 130; x++)
                thin[x, 10] = x < end || x >= end + gap;
            var graph = new VeinGraph(thin, length);
            IEnumerable<VeinLink> bridges = Enumerable.Range(0, graph.Count).SelectMany(graph.LinksOf).Where(link => link.IsBridge);

            Assert.That(bridges.Any(), Is.EqualTo(isBridged));
            if (isBridged)
                Assert.That(bridges.Min(link => link.length), Is.EqualTo(gap + 1.0).Within(1e-9));
        }

        [Test]
        public void AGapToOneSide_CostsMoreThanOneAhead()
        {
            var thin = new PixelMask(140, 60);
            for (int x = 10; x < 60; x++)
                thin[x, 10] = true;
            for (int y = 20; y < 55; y++)
                thin[60, y] = true;
            var graph = new VeinGraph(thin, 200.0);
            double[] costs = Enumerable.Range(0, graph.Count).SelectMany(graph.LinksOf).Where(link => link.IsBridge)
                .Select(link => link.dearness).Distinct().ToArray();

            Assert.That(costs, Is.EquivalentTo(new[] { 1.5, 2.5 }), "the upright line goes on to the level one, the level one does not");
        }

        // From a fork the stem of a T goes on over a gap ahead; the bar's halves go on in one another, and so do the lines of a cross.
        [TestCase(0, 0)]
        [TestCase(9, 0)]
        [TestCase(9, 6)]
        public void AFork_IsBridgedAhead_WhereNoLineGoesOn(int gap, int beyond)
        {
            const double length = 200.0;
            const int fork = 40;
            var thin = new PixelMask(140, 100);
            for (int x = 10; x < 130; x++)
                thin[x, fork] = true;
            for (int y = fork + 1; y < 90; y++)
                thin[60, y] = true;
            for (int y = 5; y < fork - gap; y++)
                thin[60, y] = true;
            for (int x = 60; x < 60 + beyond; x++)
                thin[x, fork - gap - 1] = true;
            var graph = new VeinGraph(thin, length);
            var bridges = new List<(double cost, int column, int from, int to)>();
            double shortest = double.MaxValue;
            for (int vertex = 0; vertex < graph.Count; vertex++)
            {
                foreach (VeinLink link in graph.LinksOf(vertex))
                {
                    if (!link.IsBridge)
                        continue;
                    bridges.Add((link.dearness, (int)graph[vertex].x, (int)-graph[vertex].z, (int)-graph[link.to].z));
                    shortest = Math.Min(shortest, link.length);
                }
            }

            // Where there is no gap the four lines cross; over a gap the stem and the line ahead find each other.
            if (gap == 0)
            {
                Assert.That(bridges, Is.Empty);
                return;
            }

            Assert.That(bridges, Has.Some.EqualTo((1.5, 60, fork, fork - gap - 1)), "from the fork");
            Assert.That(shortest, Is.EqualTo(gap + 1.0).Within(1e-9), "nothing is joined along the bar");
        }

        [TestCase(3, false)]
        [TestCase(6, true)]
        public void AShortSpur_IsCutOff(int spur, bool stays)
        {
            var thin = new PixelMask(120, 40);
            for (int x = 10; x < 110; x++)
                thin[x, 20] = true;
            for (int y = 20 - spur; y < 20; y++)
                thin[60, y] = true;
            var graph = new VeinGraph(thin, 200.0);

            Assert.That(graph.Count, Is.EqualTo(100 + (stays ? spur : 0)), "4 pixels are two hundredths of the wing");
            Assert.That(Enumerable.Range(0, graph.Count).Count(vertex => graph.LinesAt(vertex) == 1), Is.EqualTo(stays ? 3 : 2), "ends");
        }

        [Test]
        public void TheOrderOnTheRim_CountsFromTheFirstTip_AwayFromTheBase_EitherWayRound([Values] bool clockwise)
        {
            PlanPoint[] corners = { new PlanPoint(0, 0), new PlanPoint(4, 0), new PlanPoint(4, 2), new PlanPoint(0, 2) };
            if (clockwise)
                Array.Reverse(corners);
            var rim = new Polyline(corners, true);

            // Base on the left, leading edge above: tips at the upper right and lower right.
            PlanPoint[][] chains = { new[] { new PlanPoint(0, 1.2), new PlanPoint(3.5, 2) },
                new[] { new PlanPoint(0, 0.8), new PlanPoint(3, 0) } };
            var order = new RimOrder(rim, chains);

            Assert.That(order.Of(new PlanPoint(3.5, 2)), Is.EqualTo(0.0).Within(1e-9));
            Assert.That(order.Of(new PlanPoint(4, 1)), Is.EqualTo(1.5).Within(1e-9));
            Assert.That(order.Of(new PlanPoint(3, 0)), Is.EqualTo(3.5).Within(1e-9));
            Assert.That(order.Of(new PlanPoint(2, 2)), Is.EqualTo(-1.5).Within(1e-9), "ahead of the first tip");
            Assert.That(
                order.Of(new PlanPoint(0, 0.9)), Is.EqualTo(7.4).Within(1e-9), "behind the base's middle it counts from the other side");
            Assert.That(order.Of(new PlanPoint(0, 1.1)), Is.EqualTo(-4.4).Within(1e-9));
        }

        [Test]
        public void LinesThatFan_MeetInTheirHinge_AndParallelOnesDoNot()
        {
            var rim = new Polyline(
                new[] { new PlanPoint(5, -5), new PlanPoint(5, -95), new PlanPoint(195, -95), new PlanPoint(195, -5) }, true);
            PixelMask fan = new PixelMask(200, 100), level = new PixelMask(200, 100);
            for (int x = 40; x < 180; x++)
            {
                foreach (double slope in new[] { -0.2, -0.1, 0.0, 0.1, 0.2 })
                    fan[x, (int)Math.Floor(50.0 + slope * (x - 5))] = true;
                foreach (int row in new[] { 20, 40, 60, 80 })
                    level[x, row] = true;
            }

            PlanPoint? focus = VeinFocus.Find(new VeinGraph(Thinning.Run(fan), 190.0), rim, 190.0);
            Assert.That(focus.HasValue, Is.True);
            Assert.That(Math.Sqrt((focus.Value - new PlanPoint(5, -50)).LengthSquared), Is.LessThan(12.0));
            Assert.That(VeinFocus.Find(new VeinGraph(Thinning.Run(level), 190.0), rim, 190.0), Is.Null);
        }

        [Test]
        public void LinesThatFan_AreVeinsFromTheHingeToTheRim_CoveredWhereTheyAreSeen()
        {
            var mask = new PixelMask(200, 100);
            double[] slopes = { -0.2, -0.1, 0.0, 0.1, 0.2 };
            foreach (double slope in slopes)
                Line(mask, 40, 180, x => 50.0 + slope * (x - 5));
            List<RadialVein> veins = Radial(mask, 90.0);

            Assert.That(veins, Has.Count.EqualTo(5));
            foreach (RadialVein vein in veins)
            {
                PlanPoint root = vein.Path[0], tip = vein.Path[vein.Path.Length - 1];
                double slope = (-50.0 - tip.z) / 190.0;
                Assert.That((root - new PlanPoint(5, -50)).LengthSquared, Is.LessThan(0.01));
                Assert.That(tip.x, Is.EqualTo(195.0).Within(0.5), "on the rim");
                Assert.That(slopes.Min(wanted => Math.Abs(wanted - slope)), Is.LessThan(0.02));
                Assert.That(vein.Coverage, Is.EqualTo(140.0 / 190.0).Within(0.03), "less the little that is cut off its end");
            }
        }

        [TestCase(90.0, 8, false)]
        [TestCase(90.0, 20, true)]
        [TestCase(20.0, 45, true)]
        [TestCase(20.0, 42, false)]
        public void ALineAlongTheRim_IsTheRimsOwn_WithinThreeHundredthsOfTheLength_AndAFifthOfTheChord(double chord, int row, bool isVein)
        {
            var mask = new PixelMask(200, 100);
            Line(mask, 20, 180, x => row + 0.5);
            Assert.That(Radial(mask, chord), Has.Count.EqualTo(isVein ? 1 : 0));
        }

        [Test]
        public void AHinge_IsNotToldByLinesShorterThanTheWing()
        {
            var rim = new Polyline(
                new[] { new PlanPoint(5, -5), new PlanPoint(5, -95), new PlanPoint(195, -95), new PlanPoint(195, -5) }, true);
            foreach ((int length, bool isTold) in new[] { (30, false), (45, true) })
            {
                var mask = new PixelMask(200, 100);
                foreach (double slope in new[] { -0.3, -0.15, 0.0, 0.15, 0.3 })
                    Line(mask, 80, 80 + length, x => 50.0 + slope * (x - 5));
                Assert.That(VeinFocus.Find(new VeinGraph(Thinning.Run(mask), 190.0), rim, 190.0).HasValue, Is.EqualTo(isTold));
            }
        }

        private static List<RadialVein> Radial(PixelMask mask, double chord)
        {
            var rim = new Polyline(new[]
            {
                new PlanPoint(5, -50 + 0.5 * chord), new PlanPoint(5, -50 - 0.5 * chord), new PlanPoint(195, -50 - 0.5 * chord),
                new PlanPoint(195, -50 + 0.5 * chord),
            }, true);
            return RadialVeins.Find(new VeinGraph(Thinning.Run(mask), 190.0), rim, new PlanPoint(5, -50), 190.0);
        }

        private static void Line(PixelMask mask, int from, int to, Func<int, double> row)
        {
            for (int x = from; x < to; x++)
                mask[x, (int)Math.Floor(row(x))] = true;
        }

        [TestCase(0.48, false)]
        [TestCase(0.52, true)]
        public void AnotherThing_IsAnotherWing_FromAQuarterOfItsArea(double size, bool isWing)
        {
            WorkingPicture picture = Painted(300, (x, y) =>
                Math.Pow(x - 90, 2) + Math.Pow(y - 150, 2) < 80 * 80
                || Math.Pow(x - 235, 2) + Math.Pow(y - 150, 2) < size * size * 80 * 80 ? 20 : 240);
            if (isWing)
                Assert.That(() => WingSeparation.Of(picture), Throws.TypeOf<FormatException>().With.Message.Contains("2 wings"));
            else
                Assert.That(WingSeparation.Of(picture).Mask.Count, Is.EqualTo(Math.PI * 80 * 80).Within(3).Percent);
        }

        private static WorkingPicture Painted(int side, Func<double, double, double> shade)
        {
            byte[] shades = new byte[side * side];
            for (int k = 0; k < shades.Length; k++)
                shades[k] = (byte)Math.Round(shade(k % side, k / side));
            return new WorkingPicture(WingPicture.FromGrey(side, side, shades));
        }

        private static PixelMask Whole(int width, int height = 0)
        {
            var mask = new PixelMask(width, height == 0 ? width : height);
            for (int k = 0; k < mask.width * mask.height; k++)
                mask[k % mask.width, k / mask.width] = true;
            return mask;
        }
    }
}
