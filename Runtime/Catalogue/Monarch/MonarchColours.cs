using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>Colours and strokes that a monarch's fore and hind wing have in common.</summary>
    internal static class MonarchColours
    {
        /// <summary>Least half width of a line, in samples.</summary>
        public const double LeastFeature = 0.35;

        private const double k_SpotSpacing = 0.0365, k_OuterDepth = 0.0135, k_InnerDepth = 0.034, k_OuterRadius = 0.0055,
            k_InnerRadius = 0.0082, k_Smooth = 0.03, k_Apart = 0.004;
        private const double k_VeinHalfWidth = 0.0042, k_Flare = 0.0055, k_FlareReach = 0.13, k_Beside = 0.013;
        private const double k_GrainSize = 0.0042;
        private const float k_Grain = 0.05f;

        public static readonly Color Dark = new Color(0.075f, 0.055f, 0.05f);
        public static readonly Color Spot = new Color(0.97f, 0.95f, 0.9f);

        private static readonly Color s_Rust = new Color(0.66f, 0.25f, 0.05f);

        /// <summary>Ground between veins: rusty beside them, with the grain of its scales.</summary>
        /// <param name="ground">Its colour in the middle between veins.</param>
        /// <param name="vein">Distance of the nearest vein.</param>
        /// <param name="span">Place along the span.</param>
        /// <param name="forward">Place ahead of the hinge line.</param>
        /// <param name="softness">Distance of two samples.</param>
        public static Color Ground(Color ground, double vein, double span, double forward, double softness)
        {
            var colour = Color.Lerp(ground, s_Rust, 0.6f * Ink.Within(vein, k_Beside, 2 * k_Beside));
            return Ink.Lit(colour, 1 + k_Grain * Ink.Grain(span, forward, k_GrainSize, softness));
        }

        /// <summary>Share of a vein at a distance from it: veins widen towards the margin.</summary>
        public static float Vein(double distance, double edge, double softness)
        {
            double half = k_VeinHalfWidth + k_Flare * Math.Clamp(1 - edge / k_FlareReach, 0, 1);
            return Ink.Within(distance, Math.Max(half, LeastFeature * softness), softness);
        }

        /// <summary>Reach to which the distance of a margin counts.</summary>
        public static double MarginReach(double softness) => k_FlareReach + softness;

        /// <summary>Reach to which the distance of a vein counts.</summary>
        public static double VeinReach(double softness) => 2 * k_Beside + k_Flare + softness;

        /// <summary>
        /// Middles and radii of both rows of pale spots of a margin, span, forward, radius, …: none where the margin bends so much that
        /// they would meet.
        /// </summary>
        /// <param name="margin">Points of the margin, x, z, x, z, …, the wing on their right.</param>
        /// <param name="from">Where along the margin the first ones may lie.</param>
        /// <param name="to">Where the last ones may lie.</param>
        public static double[] Spots(IReadOnlyList<double> margin, double from, double to)
        {
            var spots = new List<double>();
            double length = Ink.Length(margin);
            for (double along = from; along < Math.Min(to, length - k_Smooth); along += k_SpotSpacing)
            {
                (double x, double z) = Ink.On(margin, along);
                (double backX, double backZ) = Ink.On(margin, Math.Max(0, along - k_Smooth));
                (double onX, double onZ) = Ink.On(margin, along + k_Smooth);
                double way = Math.Sqrt((onX - backX) * (onX - backX) + (onZ - backZ) * (onZ - backZ));
                double inX = (onZ - backZ) / way, inZ = (backX - onX) / way;
                Add(spots, x + k_OuterDepth * inX, z + k_OuterDepth * inZ, k_OuterRadius);
                double nextX = x + 0.5 * k_SpotSpacing * (onX - backX) / way, nextZ = z + 0.5 * k_SpotSpacing * (onZ - backZ) / way;
                Add(spots, nextX + k_InnerDepth * inX, nextZ + k_InnerDepth * inZ, k_InnerRadius);
            }

            return spots.ToArray();
        }

        /// <summary>Share of the spots at a place.</summary>
        public static float Spotted(double[] spots, double span, double forward, double softness)
        {
            float inside = 0f;
            for (int k = 0; k < spots.Length; k += 3)
            {
                double x = span - spots[k], z = forward - spots[k + 1];
                if (Math.Abs(x) < 2 * k_InnerRadius + softness && Math.Abs(z) < 2 * k_InnerRadius + softness)
                    inside = Math.Max(inside, Ink.Within(Math.Sqrt(x * x + z * z), spots[k + 2], softness));
            }

            return inside;
        }

        private static void Add(List<double> spots, double x, double z, double radius)
        {
            for (int k = 0; k < spots.Count; k += 3)
            {
                double apart = radius + spots[k + 2] + k_Apart;
                if ((x - spots[k]) * (x - spots[k]) + (z - spots[k + 1]) * (z - spots[k + 1]) < apart * apart)
                    return;
            }

            spots.Add(x);
            spots.Add(z);
            spots.Add(radius);
        }
    }
}
