using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>Contrast of the pixels of a picture to its ground, and the rim of a wing that follows.</summary>
    internal sealed class EdgeContrast
    {
        /// <summary>Contrast above the threshold, shades; positive where a pixel belongs to the wing.</summary>
        public readonly PixelPlane excess;

        /// <summary>Contrast at the rim, as a share of the highest one nearby: halfway through a blurred edge.</summary>
        private const float k_EdgeShare = 0.5f;

        /// <summary>Least contrast behind a clear edge, in multiples of the ground's own noise.</summary>
        private const double k_Clear = 1.5;

        /// <summary>Half of the least width of a membrane beside a vein, as a share of the longer side; shadows are narrower.</summary>
        private const double k_Broad = 0.01;

        /// <summary>Largest share of a cell's or a vein's rim beside ground; shadows and dust lie in it.</summary>
        private const double k_MostOpen = 0.4;

        private readonly PixelPlane m_Contrast;
        private readonly PixelPlane m_Highest;
        private readonly int m_Reach;
        private readonly double m_Noise;

        /// <param name="contrast">How far each pixel is from the ground, shades.</param>
        /// <param name="noise">What pixels of the ground may reach, shades.</param>
        /// <param name="blur">Width of the bell by which the picture was smoothed, pixels.</param>
        public EdgeContrast(PixelPlane contrast, double noise, double blur)
        {
            m_Contrast = contrast;
            m_Reach = (int)Math.Ceiling(2.5 * blur);
            m_Highest = contrast.Highest(m_Reach);
            m_Noise = noise;
            excess = new PixelPlane(contrast.width, contrast.height);
            for (int k = 0; k < excess.values.Length; k++)
                excess.values[k] = contrast.values[k] - Math.Max((float)noise, k_EdgeShare * m_Highest.values[k]);
        }

        /// <summary>
        /// Pixels of the wing: of positive <see cref="excess"/>, and what stands out at all in slits between its largest part, other broad
        /// ones and those that lie within. Beside a dark vein, a pale membrane has less than half of the contrast nearby, as a rim has.
        /// </summary>
        /// <param name="sure">Those of positive excess.</param>
        public PixelMask WithoutSlits(PixelMask sure)
        {
            List<PixelPart> parts = sure.Parts();
            if (parts.Count == 0)
                return sure;
            double broad = Math.Max(2.0 * m_Reach, k_Broad * Math.Max(sure.width, sure.height));
            PixelMask wing = sure.Shrunk(broad).Grown(broad);
            PixelMask inWing = m_Contrast.Above((float)m_Noise).Shrunk(m_Reach + 1.0), inner = sure.Shrunk(1.0);
            foreach (PixelPart part in parts)
            {
                int rim = part.CountOf((column, row) => !inner[column, row]),
                    open = part.CountOf((column, row) => !inner[column, row] && !inWing[column, row]);
                if (part == parts[0] || open < k_MostOpen * rim)
                    part.AddTo(wing);
            }

            wing = wing.Grown(m_Reach).Shrunk(m_Reach);
            for (int row = 0; row < wing.height; row++)
            {
                for (int column = 0; column < wing.width; column++)
                    wing[column, row] = sure[column, row] || (wing[column, row] && m_Contrast[column, row] > m_Noise);
            }

            return wing;
        }

        /// <summary>Share of a mask's rim that lies on a clear edge, 0 to 1; the picture's own edge does not count.</summary>
        public double ClearShareOfRim(PixelMask mask)
        {
            int rim = 0, clear = 0;
            for (int row = 1; row < mask.height - 1; row++)
            {
                for (int column = 1; column < mask.width - 1; column++)
                {
                    bool isInner = mask[column - 1, row] && mask[column + 1, row] && mask[column, row - 1] && mask[column, row + 1];
                    if (!mask[column, row] || isInner)
                        continue;
                    rim++;
                    clear += m_Highest[column, row] > k_Clear * m_Noise ? 1 : 0;
                }
            }

            return rim == 0 ? 1.0 : (double)clear / rim;
        }
    }
}
