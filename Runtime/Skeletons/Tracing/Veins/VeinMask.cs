using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>The pixels that lie on veins: a response above a threshold, or above a lower one and joined to such.</summary>
    internal static class VeinMask
    {
        /// <summary>Least response of a vein, shades, and in spreads of the membrane's own.</summary>
        private const double k_LeastContrast = 3.0, k_Spreads = 5.0;

        /// <summary>Response of faint stretches over that of sure ones.</summary>
        private const float k_Faint = 0.45f;

        /// <summary>Shortest vein, as a share of the wing's length.</summary>
        private const double k_Shortest = 0.06;

        /// <summary>More of the wing than this is texture, not veins.</summary>
        private const double k_MostCover = 0.35;

        /// <summary>One pixel of so many tells the membrane's own response; prime, so that no column is favoured.</summary>
        private const int k_SampleStep = 7;

        /// <summary>The mask; empty when the wing shows no lines.</summary>
        public static PixelMask Of(PixelPlane response, PixelMask wing, double length)
        {
            float sure = (float)Threshold(response, wing);
            var faint = new PixelMask(response.width, response.height);
            for (int k = 0; k < response.values.Length; k++)
                faint[k % response.width, k / response.width] = response.values[k] > k_Faint * sure;
            var veins = new PixelMask(response.width, response.height);
            foreach (PixelPart part in faint.Parts())
            {
                if (part.Extent >= k_Shortest * length && part.Any((column, row) => response[column, row] > sure))
                    part.AddTo(veins);
            }

            return veins.Count > k_MostCover * wing.Count ? new PixelMask(response.width, response.height) : veins;
        }

        private static double Threshold(PixelPlane response, PixelMask wing)
        {
            var values = new List<float>();
            for (int k = 0; k < response.values.Length; k += k_SampleStep)
            {
                if (wing[k % response.width, k / response.width])
                    values.Add(response.values[k]);
            }

            values.Sort();
            return values.Count == 0 ? double.MaxValue : Math.Max(k_LeastContrast, k_Spreads * values[values.Count / 2]);
        }
    }
}
