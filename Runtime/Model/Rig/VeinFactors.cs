using System;
using Alate.Geometry;

namespace Alate
{
    /// <summary>
    /// Stiffness of the joints of a wing with known veins, over that of a wing whose veins are all alike; 1 where no veins are known.
    /// </summary>
    internal static class VeinFactors
    {
        /// <summary>
        /// Power of a vein's width that its stiffness goes with: the second moment of area of a thin tube is π d³ t/8, and the walls t of
        /// one wing are taken to be alike.
        /// </summary>
        private const double k_Power = 3.0;

        /// <summary>
        /// Least factor, that of membrane without a vein: across their veins wings are one to two orders of magnitude softer than along
        /// them (Combes and Daniel 2003). And the largest, for veins 2.2 times as wide as usual.
        /// </summary>
        private const double k_Least = 0.1, k_Most = 10.0;

        /// <summary>
        /// [bone] Factors on the joints' stiffness; their scale is left to where the stiffness is derived, which keeps its mean.
        /// </summary>
        public static float[] Of(WingSkeleton skeleton, RestSkeleton rest, out bool areKnown)
        {
            float[] factors = new float[rest.BoneCount];
            double usual = UsualWidth(skeleton, rest);
            areKnown = usual > 0.0;
            for (int bone = 0; bone < factors.Length; bone++)
            {
                factors[bone] = areKnown
                    ? (float)Math.Min(Math.Max(Elementary.Pow(Width(skeleton, rest, bone) / usual, k_Power), k_Least), k_Most)
                    : 1f;
            }
            return factors;
        }

        // Mean over the joints that lie on a vein; 0 where none does.
        private static double UsualWidth(WingSkeleton skeleton, RestSkeleton rest)
        {
            double sum = 0.0;
            int count = 0;
            for (int bone = 0; bone < rest.BoneCount; bone++)
            {
                double width = Width(skeleton, rest, bone);
                sum += width;
                count += width > 0.0 ? 1 : 0;
            }

            return count == 0 ? 0.0 : sum / count;
        }

        private static double Width(WingSkeleton skeleton, RestSkeleton rest, int bone)
        {
            int bones = rest.jointsPerChain - 1;
            float[] widths = skeleton.Chains[bone / bones].veinWidths;
            return ChainValues.AreGiven(widths) ? ChainValues.Between(widths, (double)(bone % bones) / bones) : 0.0;
        }
    }
}
