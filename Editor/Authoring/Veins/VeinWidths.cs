using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>
    /// Widths of veins in a picture: what a line darkens or brightens across it, over the strongest contrast of all lines. Blur and coarse
    /// pixels spread a line but leave that sum, so that lines thinner than a pixel keep their ratio.
    /// </summary>
    internal sealed class VeinWidths
    {
        /// <summary>
        /// Half of the stretch across a vein on which it may lie, and half of that where the ground beside it is seen; shares of the wing's
        /// length.
        /// </summary>
        private const double k_Line = 0.012, k_Ground = 0.024;

        /// <summary>Distance of samples across a vein, pixels.</summary>
        private const double k_Across = 0.5;

        private readonly PixelPlane m_Shades;
        private readonly double m_Factor;
        private readonly double m_Length;

        /// <param name="shades">Of the wing, going on beyond its rim.</param>
        /// <param name="factor">Pixels of the picture along a side of one of the plane's.</param>
        /// <param name="length">Of the wing, pixels of the picture.</param>
        public VeinWidths(PixelPlane shades, double factor, double length)
        {
            m_Shades = shades;
            m_Factor = factor;
            m_Length = length / factor;
        }

        /// <summary>
        /// [chain][joint] Widths of the veins that chains follow, wing lengths; null for a chain without one. The leading edge without one
        /// has the largest width, for its vein lies in the rim.
        /// </summary>
        /// <param name="chains">Joints from root to tip, pixels of the picture.</param>
        /// <param name="followed">[chain] The vein, or null.</param>
        public float[][] Measure(PlanPoint[][] chains, RadialVein[] followed)
        {
            float[][] widths = new float[chains.Length][];
            double contrast = 0.0;
            for (int i = 0; i < chains.Length; i++)
                widths[i] = followed[i] == null ? null : Sums(chains[i], followed[i].Path, ref contrast);
            float widest = 0f;
            foreach (float[] own in widths)
            {
                for (int j = 0; own != null && j < own.Length; j++)
                {
                    own[j] = contrast > 0.0 ? (float)(own[j] / (contrast * m_Length)) : 0f;
                    widest = Math.Max(widest, own[j]);
                }
            }

            if (widths[0] == null && widest > 0f)
                widths[0] = new[] { widest };
            return widths;
        }

        // A joint has the middle of the sums along half a bone on either side; the root, where veins run together, and the tip, beside the
        // rim, have those of the joints beside them.
        private float[] Sums(PlanPoint[] chain, PlanPoint[] vein, ref double contrast)
        {
            float[] sums = new float[chain.Length];
            for (int j = 1; j < chain.Length; j++)
            {
                double reach = 0.5 * Math.Sqrt((chain[j] - chain[j - 1]).LengthSquared);
                var found = new List<double>();
                for (int k = 1; k + 1 < vein.Length; k++)
                {
                    if ((vein[k] - chain[j]).LengthSquared < reach * reach)
                        found.Add(Sum(vein[k] * (1.0 / m_Factor), PlanPoint.Unit(vein[k + 1] - vein[k - 1]), ref contrast));
                }

                found.Sort();
                sums[j] = found.Count == 0 ? sums[j - 1] : (float)found[found.Count / 2];
            }

            sums[0] = sums[1];
            sums[sums.Length - 1] = sums[sums.Length - 2];
            return sums;
        }

        // Of the contrast across a vein, shades times pixels.
        private double Sum(PlanPoint at, PlanPoint along, ref double contrast)
        {
            var across = new PlanPoint(-along.z, along.x);
            double ground = Ground(at, across), sum = 0.0, strongest = 0.0;
            for (double n = -k_Line * m_Length; n <= k_Line * m_Length; n += k_Across)
            {
                double difference = Shade(at + across * n) - ground;
                sum += k_Across * difference;
                strongest = Math.Max(strongest, Math.Abs(difference));
            }

            contrast = Math.Max(contrast, strongest);
            return Math.Abs(sum);
        }

        private double Ground(PlanPoint at, PlanPoint across)
        {
            var shades = new List<double>();
            for (double n = k_Line * m_Length; n <= k_Ground * m_Length; n += k_Across)
            {
                shades.Add(Shade(at + across * n));
                shades.Add(Shade(at - across * n));
            }

            shades.Sort();
            return shades[shades.Count / 2];
        }

        // Bilinear.
        private double Shade(PlanPoint at)
        {
            double x = Math.Min(Math.Max(at.x - 0.5, 0.0), m_Shades.width - 1.001),
                y = Math.Min(Math.Max(-at.z - 0.5, 0.0), m_Shades.height - 1.001);
            int column = (int)x, row = (int)y;
            double u = x - column, v = y - row;
            return (1.0 - v) * ((1.0 - u) * m_Shades[column, row] + u * m_Shades[column + 1, row])
                + v * ((1.0 - u) * m_Shades[column, row + 1] + u * m_Shades[column + 1, row + 1]);
        }
    }
}
