using System;
using System.Collections.Generic;

namespace Alate.Authoring
{
    /// <summary>The pixels that lie on veins: a response above a threshold, or above a lower one and joined to such.</summary>
    internal static class VeinMask
    {
        /// <summary>Least response of a vein, in shades, and in medians of the whole wing.</summary>
        private const float k_LeastContrast = 3f, k_Middles = 5f;

        /// <summary>Response of faint stretches over that of sure ones.</summary>
        private const float k_Faint = 0.45f;

        /// <summary>Largest share of the wing that faint stretches may cover; with more, only the strongest count.</summary>
        private const double k_MostCover = 0.28;

        /// <summary>Shortest vein, as a share of the wing's length.</summary>
        private const double k_Shortest = 0.06;

        /// <summary>The mask; empty when the wing shows no lines.</summary>
        public static PixelMask Of(PixelPlane response, PixelMask wing, double length)
        {
            List<float> usual = response.Sampled(wing);
            usual.Insert(0, 0f);
            float sure = Math.Max(k_LeastContrast, k_Middles * usual[usual.Count / 2]);
            float faint = Math.Max(k_Faint * sure, usual[(int)((1.0 - k_MostCover) * (usual.Count - 1))]);
            sure = Math.Max(sure, 1.5f * faint);
            var veins = new PixelMask(response.width, response.height);
            foreach (PixelPart part in response.Above(faint).Parts())
            {
                if (part.Extent >= k_Shortest * length && part.Any((column, row) => response[column, row] > sure))
                    part.AddTo(veins);
            }

            return veins;
        }
    }
}
