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

        /// <summary>Step between the pixels that give the wing's own response; prime, so that no column is favoured.</summary>
        private const int k_SampleStep = 7;

        /// <summary>The mask; empty when the wing shows no lines.</summary>
        public static PixelMask Of(PixelPlane response, PixelMask wing, double length)
        {
            float[] usual = Sorted(response, wing);
            float sure = Math.Max(k_LeastContrast, k_Middles * usual[usual.Length / 2]);
            float faint = Math.Max(k_Faint * sure, usual[(int)((1.0 - k_MostCover) * (usual.Length - 1))]);
            sure = Math.Max(sure, 1.5f * faint);
            var candidates = new PixelMask(response.width, response.height);
            for (int k = 0; k < response.values.Length; k++)
                candidates[k % response.width, k / response.width] = response.values[k] > faint;
            var veins = new PixelMask(response.width, response.height);
            foreach (PixelPart part in candidates.Parts())
            {
                if (part.Extent >= k_Shortest * length && part.Any((column, row) => response[column, row] > sure))
                    part.AddTo(veins);
            }

            return veins;
        }

        private static float[] Sorted(PixelPlane response, PixelMask wing)
        {
            var values = new List<float> { 0f };
            for (int k = 0; k < response.values.Length; k += k_SampleStep)
            {
                if (wing[k % response.width, k / response.width])
                    values.Add(response.values[k]);
            }

            values.Sort();
            return values.ToArray();
        }
    }
}
