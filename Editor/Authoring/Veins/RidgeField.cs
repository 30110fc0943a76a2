using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>
    /// Likeness of each pixel of a wing to the middle of a thin line: the curvature of the shades across it, at several widths, less that
    /// along it (the eigenvalues of the Hessian matrix; Lindeberg, 1998).
    /// </summary>
    internal static class RidgeField
    {
        /// <summary>
        /// Widths of the bells with which lines are matched, pixels, and their share of the wing's length where that is more.
        /// </summary>
        private static readonly double[] s_Widths = { 1.0, 1.8, 3.2 };
        private const double k_WidthShare = 0.0012;

        /// <summary>
        /// Distance from the rim, as a share of the wing's length, within which pixels are left out: the rim's own line lies there.
        /// </summary>
        private const double k_RimShare = 0.012;

        /// <summary>
        /// Pixels of the rim that are mixed with ground, and width of the bell by which shades go on beyond them, pixels.
        /// </summary>
        private const double k_Mixed = 2.0, k_Reach = 6.0;

        /// <summary>Share of the pixels with the strongest response by which dark and bright lines are compared.</summary>
        private const double k_Strongest = 0.03;

        /// <summary>Computes the field, in shades of contrast, for dark lines or for bright ones, whichever stand out more.</summary>
        public static PixelPlane Of(WorkingPicture picture, PixelMask wing, double length)
        {
            PixelPlane shades = Shades(picture, wing);
            PixelMask inner = wing.Shrunk(Math.Max(2.0, k_RimShare * length));
            var dark = new PixelPlane(shades.width, shades.height);
            var bright = new PixelPlane(shades.width, shades.height);
            foreach (double width in s_Widths)
                AddResponse(shades, inner, Math.Max(1.0, k_WidthShare * length) * width, dark, bright);
            return Strength(dark, inner) >= Strength(bright, inner) ? dark : bright;
        }

        /// <summary>
        /// Shades of grey of the wing. Ground at the rim would look like a line's edge; the wing's own shades go on into it instead.
        /// </summary>
        public static PixelPlane Shades(WorkingPicture picture, PixelMask wing)
        {
            var shades = new PixelPlane(picture.Width, picture.Height);
            var known = new PixelPlane(picture.Width, picture.Height);
            PixelMask sure = wing.Shrunk(k_Mixed);
            for (int k = 0; k < shades.values.Length; k++)
            {
                bool inside = sure[k % picture.Width, k / picture.Width];
                float shade = 0.299f * picture.Red.values[k] + 0.587f * picture.Green.values[k] + 0.114f * picture.Blue.values[k];
                shades.values[k] = inside ? shade : 0f;
                known.values[k] = inside ? 1f : 0f;
            }

            PixelPlane blurred = shades.Blurred(k_Reach), weight = known.Blurred(k_Reach);
            for (int k = 0; k < shades.values.Length; k++)
            {
                if (known.values[k] == 0f && weight.values[k] > 1e-4f)
                    shades.values[k] = blurred.values[k] / weight.values[k];
            }

            return shades;
        }

        private static void AddResponse(PixelPlane shades, PixelMask inner, double width, PixelPlane dark, PixelPlane bright)
        {
            float[] blurred = shades.Blurred(width).values;
            float scale = (float)(width * width);
            int down = shades.width;
            for (int row = 1; row + 1 < shades.height; row++)
            {
                for (int column = 1; column + 1 < shades.width; column++)
                {
                    if (!inner[column, row])
                        continue;
                    int k = row * down + column;
                    float middle = blurred[k];
                    float xx = blurred[k + 1] - 2f * middle + blurred[k - 1];
                    float yy = blurred[k + down] - 2f * middle + blurred[k - down];
                    float xy = 0.25f * (blurred[k + down + 1] - blurred[k - down + 1] - blurred[k + down - 1] + blurred[k - down - 1]);
                    float mean = 0.5f * (xx + yy), spread = MathF.Sqrt(0.25f * (xx - yy) * (xx - yy) + xy * xy);
                    float high = mean + spread, low = mean - spread;
                    float isDark = scale * (high - Math.Abs(low)), isBright = scale * (-low - Math.Abs(high));
                    if (isDark > dark.values[k])
                        dark.values[k] = isDark;
                    if (isBright > bright.values[k])
                        bright.values[k] = isBright;
                }
            }
        }

        private static double Strength(PixelPlane response, PixelMask inner)
        {
            List<float> values = response.Sampled(inner);
            double sum = 0.0;
            for (int k = (int)((1.0 - k_Strongest) * values.Count); k < values.Count; k++)
                sum += values[k];
            return sum;
        }
    }
}
