using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Shares of the flap that each joint adds to the root's. On a fan every chain takes them evenly by its own joints (Eq. 3's sum). On a
    /// ribbon, whose chains lie side by side and end at different distances, this would shear the membrane: there each bone turns as the
    /// leading chain does over the same distance from the root.
    /// </summary>
    internal static class FlapShares
    {
        /// <summary>[bone] Sums of the shares from the root to each bone; 0 for the first bone of the leading chain, at most 1.</summary>
        /// <param name="rest">The skeleton.</param>
        /// <param name="spread">0 for a ribbon, 1 for a fan.</param>
        public static float[] Cumulative(RestSkeleton rest, float spread)
        {
            int bones = rest.jointsPerChain - 1;
            float[] sums = new float[rest.BoneCount];
            for (int bone = 0; bone < sums.Length; bone++)
            {
                int joint = rest.InnerJoint(bone), root = joint - bone % bones;
                float even = bones > 1 ? (float)(bone % bones) / (bones - 1) : 0f;
                float from = math.distance(rest.joints[joint], rest.joints[root]),
                    to = math.distance(rest.joints[joint + 1], rest.joints[root]);
                sums[bone] = math.lerp(Mean(rest, from, to), even, spread);
            }

            return sums;
        }

        // Of the leading chain's sums over the distances from the root, which are constant along each bone; beyond its tip the last one.
        private static float Mean(RestSkeleton rest, float from, float to)
        {
            int bones = rest.jointsPerChain - 1;
            float sum = 0f, length = to - from;
            for (int j = 1; j < bones; j++)
            {
                float start = math.distance(rest.joints[j], rest.joints[0]);
                sum += math.saturate((to - start) / length) / (bones - 1);
            }

            return sum;
        }
    }
}
