using System;
using System.Linq;
using Alate.Authoring;
using NUnit.Framework;

namespace Alate.Editor.Tests
{
    /// <summary>Thinned pixels against the two conditions of Guo and Hall (1989), as the paper numbers the neighbours.</summary>
    public sealed class ThinningLaws
    {
        private const int k_Width = 26, k_Height = 19;

        [Test]
        public void AnyPixels_AreThinnedAsThePaperSays(
            [Values(0.3, 0.5, 0.7, 0.9)] double share, [Values(1, 2, 3, 4, 5, 6)] int seed)
        {
            var random = new Random(seed);
            var mask = new PixelMask(k_Width, k_Height);
            bool[] pixels = Enumerable.Range(0, k_Width * k_Height).Select(_ => random.NextDouble() < share).ToArray();
            for (int k = 0; k < pixels.Length; k++)
                mask[k % k_Width, k / k_Width] = pixels[k];

            PixelMask thin = Thinning.Run(mask);
            for (int half = 0, still = 0; still < 2; half = 1 - half)
            {
                bool[] next = pixels.Select((set, k) => set && !IsDeletable(pixels, k, half)).ToArray();
                still = next.SequenceEqual(pixels) ? still + 1 : 0;
                pixels = next;
            }

            Assert.That(Enumerable.Range(0, pixels.Length).Select(k => thin[k % k_Width, k / k_Width]), Is.EqualTo(pixels));
        }

        // p2 lies above the pixel, the others follow clockwise.
        private static bool IsDeletable(bool[] pixels, int at, int half)
        {
            int[] x = { 0, 1, 1, 1, 0, -1, -1, -1 }, y = { -1, -1, 0, 1, 1, 1, 0, -1 };
            int[] p = new int[10];
            for (int k = 0; k < 8; k++)
            {
                int column = at % k_Width + x[k], row = at / k_Width + y[k];
                bool isWithin = column >= 0 && row >= 0 && column < k_Width && row < k_Height;
                p[k + 2] = isWithin && pixels[row * k_Width + column] ? 1 : 0;
            }

            int crossings = (1 - p[2]) * (p[3] | p[4]) + (1 - p[4]) * (p[5] | p[6]) + (1 - p[6]) * (p[7] | p[8])
                + (1 - p[8]) * (p[9] | p[2]);
            int before = (p[9] | p[2]) + (p[3] | p[4]) + (p[5] | p[6]) + (p[7] | p[8]);
            int behind = (p[2] | p[3]) + (p[4] | p[5]) + (p[6] | p[7]) + (p[8] | p[9]);
            int neighbours = Math.Min(before, behind);
            int side = half == 0 ? (p[2] | p[3] | (1 - p[5])) & p[4] : (p[6] | p[7] | (1 - p[9])) & p[8];
            return crossings == 1 && neighbours >= 2 && neighbours <= 3 && side == 0;
        }
    }
}
