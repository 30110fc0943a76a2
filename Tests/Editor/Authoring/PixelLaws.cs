using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Authoring;
using NUnit.Framework;
using UnityEngine;

namespace Alate.Editor.Tests
{
    /// <summary>Laws of sets and planes of pixels, against a look at every pixel and closed forms.</summary>
    public sealed class PixelLaws
    {
        [TestCase(0.5)]
        [TestCase(1.0)]
        [TestCase(2.2)]
        [TestCase(3.9)]
        public void AMask_GrowsAndShrinksByADistance_AsALookAtAllPixelsSays(double radius)
        {
            PixelMask mask = Scattered(0.12, 4), dense = Scattered(0.9, 5);
            PixelMask grown = mask.Grown(radius), shrunk = dense.Shrunk(radius);
            for (int k = 0; k < mask.width * mask.height; k++)
            {
                int x = k % mask.width, y = k / mask.width;
                bool near = false, free = true;
                for (int other = 0; other < mask.width * mask.height; other++)
                {
                    int dx = other % mask.width - x, dy = other / mask.width - y;
                    bool isWithin = dx * dx + dy * dy <= radius * radius;
                    near |= isWithin && mask[other % mask.width, other / mask.width];
                    free &= !isWithin || dense[other % mask.width, other / mask.width];
                }

                Assert.That((grown[x, y], shrunk[x, y]), Is.EqualTo((near, free)), $"at {x}, {y}");
            }
        }

        [Test]
        public void Holes_AreFilled_ButNotBaysThatReachThePicturesEdge()
        {
            PixelMask ring = Of("########", "#..##..#", "#..##..#", "########", "..##..##", "..######");
            PixelMask filled = ring.Filled();

            Assert.That(Text(filled), Is.EqualTo(new[] { "########", "########", "########", "########", "..######", "..######" }));
            Assert.That((ring.Count, filled.Count), Is.EqualTo((34, 44)));
            Assert.That(Text(Of("#...#", ".....", "#...#").Filled()), Is.EqualTo(new[] { "#...#", ".....", "#...#" }));
        }

        [Test]
        public void APart_KnowsItsBounds_InWhateverOrderItsPixelsCome()
        {
            var part = new PixelPart(9);
            foreach ((int column, int row) in new[] { (3, 4), (7, 6), (8, 0), (5, 5), (4, 2) })
                part.Add(column, row);
            Assert.That(part.Extent, Is.EqualTo(7), "seven rows, six columns");
            Assert.That((part.SidesReached(7), part.SidesReached(8)), Is.EqualTo((3, 2)), "right and above, and below of seven rows");
        }

        [Test]
        public void Parts_TouchBySidesOrCorners_TheLargestFirst_AndKnowTheirBounds()
        {
            PixelMask mask = Of("##....#", "..#....", "...#..#", ".....#.", ".......");
            List<PixelPart> parts = mask.Parts();

            Assert.That(parts.Select(part => part.Count), Is.EqualTo(new[] { 4, 2, 1 }));
            Assert.That(parts.Select(part => part.Extent), Is.EqualTo(new[] { 4, 2, 1 }));
            Assert.That(parts.Select(part => part.SidesReached(5)), Is.EqualTo(new[] { 2, 1, 2 }));
            Assert.That(parts[1].Any((column, row) => column == 5 && row == 3), Is.True);
            Assert.That(parts[1].Any((column, row) => column == 3 && row == 5), Is.False);
            Assert.That(Text(parts[1].ToMask(5)), Is.EqualTo(new[] { ".......", ".......", "......#", ".....#.", "......." }));
            Assert.That((mask.Contains(6, 0), mask.Contains(7, 0), mask.Contains(-1, 0), mask.Contains(0, 5)),
                Is.EqualTo((true, false, false, false)));
        }

        [TestCase(0.8)]
        [TestCase(2.5)]
        public void Blurring_SpreadsAPixelIntoABell_WithItsSumAndItsWidth(double sigma)
        {
            var plane = new PixelPlane(41, 45);
            plane[20, 22] = 1000f;
            PixelPlane blurred = plane.Blurred(sigma);
            double sum = 0.0, across = 0.0, down = 0.0, x = 0.0, y = 0.0;
            for (int k = 0; k < blurred.values.Length; k++)
            {
                double value = blurred.values[k], dx = k % 41 - 20, dy = k / 41 - 22;
                sum += value;
                x += value * dx;
                y += value * dy;
                across += value * dx * dx;
                down += value * dy * dy;
            }

            Assert.That(sum, Is.EqualTo(1000.0).Within(0.01));
            Assert.That(Math.Abs(x / sum) + Math.Abs(y / sum), Is.LessThan(1e-5));
            Assert.That(Math.Sqrt(across / sum), Is.EqualTo(sigma).Within(0.02 * sigma));
            Assert.That(Math.Sqrt(down / sum), Is.EqualTo(sigma).Within(0.02 * sigma));
            Assert.That(blurred[20, 22 + 2] / blurred[20, 22], Is.EqualTo(Math.Exp(-2.0 / (sigma * sigma))).Within(1e-4));
        }

        [Test]
        public void Blurring_GoesOnBeyondTheRim_AsItsLastPixels()
        {
            var plane = new PixelPlane(12, 9);
            for (int k = 0; k < plane.values.Length; k++)
                plane.values[k] = k / 12 < 4 ? 10f : 30f;
            PixelPlane blurred = plane.Blurred(1.5);
            for (int column = 0; column < 12; column++)
                Assert.That(blurred[column, 4] + blurred[column, 3], Is.EqualTo(40f).Within(1e-3f), "odd about the step");
            Assert.That(Math.Abs(blurred[0, 0] - 10f) + Math.Abs(blurred[11, 8] - 30f), Is.LessThan(0.2f));
        }

        [Test]
        public void TheHighest_IsThatOfASquare_AndLimitsLeaveEqualOnesOut()
        {
            var plane = new PixelPlane(13, 11);
            var random = new System.Random(2);
            for (int k = 0; k < plane.values.Length; k++)
                plane.values[k] = random.Next(100);
            PixelPlane highest = plane.Highest(2);
            for (int k = 0; k < plane.values.Length; k++)
            {
                float most = float.MinValue;
                for (int y = Math.Max(0, k / 13 - 2); y <= Math.Min(10, k / 13 + 2); y++)
                {
                    for (int x = Math.Max(0, k % 13 - 2); x <= Math.Min(12, k % 13 + 2); x++)
                        most = Math.Max(most, plane[x, y]);
                }

                Assert.That(highest.values[k], Is.EqualTo(most));
            }

            Assert.That(plane.Above(40f).Count, Is.EqualTo(plane.values.Count(value => value > 40f)));
            Assert.That(plane.Sampled(plane.Above(-1f)), Is.Ordered.And.EquivalentTo(plane.values.Where((_, k) => k % 7 == 0)));
        }

        [Test]
        public void SmoothSurfaces_AreTheQuadratics_ThatWeightedPixelsLieOn()
        {
            var surfaces = new SmoothSurfaces(60, 40, 2);
            var random = new System.Random(7);
            double One(double x, double y) => 3.0 + 0.2 * x - 0.5 * y + 0.01 * x * x - 0.02 * x * y + 0.03 * y * y;
            double Two(double x, double y) => -7.0 + 0.9 * y - 0.004 * x * x;
            for (int k = 0; k < 200; k++)
            {
                int x = random.Next(60), y = random.Next(40);
                bool counts = k % 3 > 0;
                surfaces.Add(
                    x, y, new[] { counts ? One(x, y) : 999.0, counts ? Two(x, y) : -99.0 }, counts ? 0.2 + random.NextDouble() : 0.0);
            }

            surfaces.Fit();
            for (int k = 0; k < 50; k++)
            {
                int x = random.Next(60), y = random.Next(40);
                Assert.That(Math.Abs(surfaces.At(0, x, y) - One(x, y)) + Math.Abs(surfaces.At(1, x, y) - Two(x, y)), Is.LessThan(1e-3));
            }
        }

        [Test]
        public void Weights_CountInProportion()
        {
            // Two values in one place for each of a grid of pixels: the surface lies between them by their weights.
            var surfaces = new SmoothSurfaces(20, 20, 1);
            for (int k = 0; k < 400; k++)
            {
                surfaces.Add(k % 20, k / 20, new[] { 10.0 }, 3.0);
                surfaces.Add(k % 20, k / 20, new[] { 20.0 }, 1.0);
            }

            surfaces.Fit();
            Assert.That(surfaces.At(0, 5, 13), Is.EqualTo(12.5).Within(1e-6));
        }

        [Test]
        public void Ground_IsASurfaceAcrossThePicture_FromWhichColoursDifferByTheRootOfTheirMeanSquare()
        {
            const int side = 80;
            PixelPlane[] channels = { new PixelPlane(side, side), new PixelPlane(side, side), new PixelPlane(side, side) };
            for (int k = 0; k < side * side; k++)
            {
                bool isWing = Math.Abs(k % side - 40) < 15 && Math.Abs(k / side - 40) < 25;
                channels[0].values[k] = 100f + 0.5f * (k % side) + (isWing ? 30f : 0f);
                channels[1].values[k] = 150f - 0.3f * (k / side) - (isWing ? 60f : 0f);
                channels[2].values[k] = 200f + (isWing ? 20f : 0f);
            }

            // A rim of the wing is left among the ground.
            var known = new PixelMask(side, side);
            for (int k = 0; k < side * side; k++)
                known[k % side, k / side] = Math.Abs(k % side - 40) < 13 && Math.Abs(k / side - 40) < 24;
            foreach (PlainGround ground in new[] { PlainGround.FromBorder(channels), PlainGround.Outside(known, channels) })
            {
                Assert.That(ground.Distance[40, 40], Is.EqualTo(Math.Sqrt((900.0 + 3600.0 + 400.0) / 3.0)).Within(0.05),
                    "also where the wing stands among the ground");
                Assert.That(ground.Distance[5, 70], Is.EqualTo(0f).Within(0.05f));
                Assert.That(ground.Noise, Is.EqualTo(8.0), "at least eight shades");
            }
        }

        [Test]
        public void NoisyGround_IsToldFromTheWingBySixSpreads()
        {
            const int side = 120;
            var plane = new PixelPlane(side, side);
            var random = new System.Random(4);
            for (int k = 0; k < plane.values.Length; k++)
            {
                plane.values[k] = 100f
                    + 10f * (float)(Math.Sqrt(-2.0 * Math.Log(1.0 - random.NextDouble())) * Math.Cos(2.0 * Math.PI * random.NextDouble()));
            }
            double noise = PlainGround.Outside(plane.Above(999f), plane).Noise;

            // Of the distances of a bell of width 10: median 6.745, and 1.4826 times the median distance from that, 5.93.
            Assert.That(noise, Is.EqualTo(6.745 + 6.0 * 5.93).Within(2.0));
        }

        [Test]
        public void AnEdge_LiesHalfwayUpToTheHighestContrastNearby_OrAtTheNoise()
        {
            var contrast = new PixelPlane(30, 9);
            for (int k = 0; k < contrast.values.Length; k++)
                contrast.values[k] = Math.Min(100f, Math.Max(0f, 20f * (k % 30 - 10)));
            var edge = new EdgeContrast(contrast, 12.0, 2.0);

            Assert.That(edge.excess[12, 4], Is.EqualTo(40f - 50f), "five pixels on the contrast is 100");
            Assert.That(edge.excess[13, 4], Is.EqualTo(60f - 50f));
            Assert.That(edge.excess[9, 4], Is.EqualTo(0f - 40f));
            Assert.That(edge.excess[5, 4], Is.EqualTo(-12f), "no contrast nearby");
        }

        [TestCase(18.1f, 1.0)]
        [TestCase(17.9f, 0.0)]
        public void ARim_IsClear_WhereTheContrastBehindIsOneAndAHalfTimesTheNoise(float behind, double share)
        {
            var contrast = new PixelPlane(20, 20);
            var mask = new PixelMask(20, 20);
            for (int k = 0; k < 400; k++)
            {
                bool isInside = Math.Abs(k % 20 - 10) < 5 && Math.Abs(k / 20 - 10) < 5;
                contrast.values[k] = isInside ? behind : 0f;
                mask[k % 20, k / 20] = isInside;
            }

            Assert.That(new EdgeContrast(contrast, 12.0, 1.0).ClearShareOfRim(mask), Is.EqualTo(share));
            Assert.That(new EdgeContrast(contrast, 12.0, 1.0).ClearShareOfRim(new PixelMask(20, 20)), Is.EqualTo(1.0), "no rim");
        }

        [TestCase(1400, 1)]
        [TestCase(1401, 2)]
        [TestCase(2801, 3)]
        public void AWorkingPicture_IsTheMeanOfWholeSquaresOfPixels_InItsOwnChannels(int width, int factor)
        {
            const int height = 64;
            var pixels = new Color32[width * height];
            for (int k = 0; k < pixels.Length; k++)
                pixels[k] = new Color32((byte)(k % width % 251), (byte)(k / width), (byte)(k % 7), (byte)(200 + k % 5));
            var working = new WorkingPicture(new WingPicture(width, height, pixels));

            Assert.That((working.Factor, working.Width, working.Height, working.HasTransparentGround),
                Is.EqualTo((factor, width / factor, height / factor, false)));
            int column = working.Width - 2, row = working.Height - 3;
            float[] sums = new float[4];
            for (int k = 0; k < factor * factor; k++)
            {
                Color32 pixel = pixels[(row * factor + k / factor) * width + column * factor + k % factor];
                sums[0] += pixel.r;
                sums[1] += pixel.g;
                sums[2] += pixel.b;
                sums[3] += pixel.a;
            }

            float[] found = { working.Red[column, row], working.Green[column, row], working.Blue[column, row], working.Alpha[column, row] };
            Assert.That(found, Is.EqualTo(sums.Select(sum => sum / (factor * factor))).Within(1e-3f));
        }

        [TestCase(0.49, 0, false)]
        [TestCase(0.51, 0, true)]
        [TestCase(1.0, 127, true)]
        [TestCase(1.0, 128, false)]
        public void Ground_IsTransparent_WhereMostOfTheBorderIs(double share, byte alpha, bool isTransparent)
        {
            const int side = 101;
            var pixels = new Color32[side * side];
            var border = new List<int>();
            for (int k = 0; k < pixels.Length; k++)
            {
                pixels[k] = new Color32(1, 2, 3, 255);
                if (k % side == 0 || k % side == side - 1 || k / side == 0 || k / side == side - 1)
                    border.Add(k);
            }

            for (int k = 0; k < (int)(share * border.Count); k++)
                pixels[border[k]].a = alpha;
            Assert.That(new WorkingPicture(new WingPicture(side, side, pixels)).HasTransparentGround, Is.EqualTo(isTransparent));
        }

        [Test]
        public void ThinLines_ArePixelsWide_AsLongAsTheyWere_AndHangTogetherAsBefore()
        {
            var bars = new PixelMask(60, 40);
            for (int k = 0; k < 60 * 40; k++)
            {
                int x = k % 60, y = k / 60;
                bars[x, y] = x > 4 && x < 50 && Math.Abs(y - 10) < 3 || x > 4 && x < 50 && Math.Abs(y - 30) < 4
                    || Math.Abs(x - 25) < 3 && y > 10 && y < 30;
            }

            PixelMask thin = Thinning.Run(bars);
            Assert.That(thin.Parts(), Has.Count.EqualTo(1));
            Assert.That(thin.Parts()[0].Extent, Is.InRange(39, 45));
            Assert.That(thin.Count, Is.InRange(39 + 39 + 17, 45 + 45 + 25));
            for (int k = 0; k < 60 * 40; k++)
            {
                int x = k % 60, y = k / 60;
                Assert.That(!thin[x, y] || bars[x, y], Is.True, "of pixels of the bars");
                if (x < 59 && y < 39)
                    Assert.That(thin[x, y] && thin[x + 1, y] && thin[x, y + 1] && thin[x + 1, y + 1], Is.False, "no square of pixels");
            }

            for (int x = 10; x < 20; x++)
                Assert.That(thin[x, 10] && thin[x, 30], Is.True, "the middle of the bars stays");
            Assert.That(Thinning.Run(thin).Count, Is.EqualTo(thin.Count), "thin lines stay");
        }

        private static PixelMask Scattered(double share, int seed)
        {
            var random = new System.Random(seed);
            var mask = new PixelMask(23, 17);
            for (int k = 0; k < 23 * 17; k++)
                mask[k % 23, k / 23] = random.NextDouble() < share;
            return mask;
        }

        private static PixelMask Of(params string[] rows)
        {
            var mask = new PixelMask(rows[0].Length, rows.Length);
            for (int row = 0; row < rows.Length; row++)
            {
                for (int column = 0; column < mask.width; column++)
                    mask[column, row] = rows[row][column] == '#';
            }

            return mask;
        }

        private static string[] Text(PixelMask mask) => Enumerable.Range(0, mask.height)
            .Select(row => new string(Enumerable.Range(0, mask.width).Select(column => mask[column, row] ? '#' : '.').ToArray())).ToArray();
    }
}
