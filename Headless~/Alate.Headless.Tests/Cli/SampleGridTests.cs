using Alate.Drawing;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Cli
{
    public sealed class SampleGridTests
    {
        private static readonly float3 s_Paper = new float3(1f, 1f, 1f);
        private static readonly float4 s_Red = new float4(1f, 0f, 0f, 1f), s_Blue = new float4(0f, 0f, 1f, 1f);

        [Test]
        public void TheNearest_IsSeen_WhicheverComesFirst([Values] bool nearFirst)
        {
            var grid = new SampleGrid(1, 1);
            Fill(grid, nearFirst ? 1f : 2f, nearFirst ? s_Red : s_Blue, 0);
            Fill(grid, nearFirst ? 2f : 1f, nearFirst ? s_Blue : s_Red, 0);

            Assert.That(grid.Pixels(s_Paper)[0], Is.EqualTo(new Color32(255, 0, 0, 255)));
        }

        [Test]
        public void ThroughGlass_OneSeesWhatIsBehind_AndNothingOfGlassBehindIt()
        {
            var grid = new SampleGrid(1, 1);
            Fill(grid, 3f, new float4(0f, 1f, 0f, 0.5f), 1);
            Fill(grid, 2f, s_Red, 0);
            Fill(grid, 1f, new float4(0f, 0f, 1f, 0.5f), 2);
            Color32 seen = grid.Pixels(s_Paper)[0];

            Assert.That(seen.g, Is.Zero);
            Assert.That(seen.r, Is.EqualTo(seen.b).And.GreaterThan(100));
        }

        [Test]
        public void NearerGlass_LiesOverFartherGlass_WhicheverComesFirst([Values] bool nearFirst)
        {
            var grid = new SampleGrid(1, 1);
            float4 near = new float4(1f, 0f, 0f, 0.75f), far = new float4(0f, 0f, 1f, 0.75f);
            Fill(grid, nearFirst ? 1f : 2f, nearFirst ? near : far, nearFirst ? 1 : 2);
            Fill(grid, nearFirst ? 2f : 1f, nearFirst ? far : near, nearFirst ? 2 : 1);
            Color32 seen = grid.Pixels(s_Paper)[0];

            Assert.That(seen.r, Is.GreaterThan(seen.b));
        }

        [Test]
        public void OneSheetOfGlass_MetTwiceAtAnEdge_CountsOnce_ButAFoldCountsTwice()
        {
            var once = new SampleGrid(1, 1);
            var edge = new SampleGrid(1, 1);
            var fold = new SampleGrid(1, 1);
            var black = new float4(0f, 0f, 0f, 0.5f);
            Fill(once, 1f, black, 1);
            Fill(edge, 1f, black, 1);
            Fill(edge, 1.00001f, black, 1);
            Fill(fold, 1f, black, 1);
            Fill(fold, 1.1f, black, 1);

            Assert.That(edge.Pixels(s_Paper)[0], Is.EqualTo(once.Pixels(s_Paper)[0]));
            Assert.That(fold.Pixels(s_Paper)[0].r, Is.LessThan(once.Pixels(s_Paper)[0].r));
        }

        [Test]
        public void OutsideTheGrid_NothingIsSeen()
        {
            var grid = new SampleGrid(2, 1);

            Assert.That(grid.IsSeen(-1, 0, 1f) || grid.IsSeen(0, -1, 1f) || grid.IsSeen(2 * SampleGrid.k_Fineness, 0, 1f), Is.False);
            Assert.That(grid.IsSeen(2 * SampleGrid.k_Fineness - 1, SampleGrid.k_Fineness - 1, 1f), Is.True);
        }

        [Test]
        public void ALineAcrossRows_IsAsDarkEverywhere_AsALineOnARow([Values(0, 1, 2, 3)] int shift)
        {
            // A black line of a pixel's height, on a row or between two: what it takes from the white around it is one pixel's value in
            // every column.
            var grid = new SampleGrid(1, 6);
            for (int y = 0; y < SampleGrid.k_Fineness; y++)
            {
                for (int x = 0; x < SampleGrid.k_Fineness; x++)
                    grid.Add(x, 2 * SampleGrid.k_Fineness + y + shift, 1f, new float4(0f, 0f, 0f, 1f), 0);
            }

            double taken = 0.0;
            Color32[] pixels = grid.Pixels(s_Paper);
            foreach (Color32 pixel in pixels)
                taken += 255 - pixel.r;

            Assert.That(taken, Is.EqualTo(255.0).Within(2.0));
            Assert.That(pixels[0].r == 255 && pixels[5].r == 255, Is.True);
        }

        // The tent: a ninth at its top, a third of that for each sample aside, to 0 in the neighbour's middle.
        [Test]
        public void ASample_WeighsByTheTent_InThePixelsAroundIt()
        {
            for (int sample = 0; sample < 9 * 12; sample++)
            {
                int x = sample % 9, y = sample / 9;
                var grid = new SampleGrid(3, 4);
                grid.Add(x, y, 1f, new float4(0f, 0f, 0f, 1f), 0);
                Color32[] pixels = grid.Pixels(s_Paper);
                for (int k = 0; k < pixels.Length; k++)
                {
                    int right = System.Math.Abs(x - 3 * (k % 3) - 1), down = System.Math.Abs(y - 3 * (k / 3) - 1);
                    double weight = System.Math.Max(3 - right, 0) * System.Math.Max(3 - down, 0) / 81.0;
                    // Beyond the edge the outermost samples go on.
                    if ((x == 0 || x == 8) && right == 1)
                        weight *= 3.0 / 2;
                    if ((y == 0 || y == 11) && down == 1)
                        weight *= 3.0 / 2;
                    Assert.That(pixels[k].r, Is.EqualTo(255 * (1 - weight)).Within(0.51), $"{x}, {y} in {k}");
                }
            }
        }

        private static void Fill(SampleGrid grid, float depth, float4 light, int surface)
        {
            for (int k = 0; k < SampleGrid.k_Fineness * SampleGrid.k_Fineness; k++)
            {
                int x = k % SampleGrid.k_Fineness, y = k / SampleGrid.k_Fineness;
                if (grid.IsSeen(x, y, depth))
                    grid.Add(x, y, depth, light, surface);
            }
        }
    }
}
