using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>The strips between neighbouring chains: one for every joint that has a foot on the chain beside it.</summary>
    internal sealed class StripNetwork
    {
        /// <summary>Least width of a strip, wing lengths.</summary>
        private const float k_LeastWidth = 2e-3f;

        /// <summary>
        /// Largest distance of a foot past the end of a chain, in lengths of its last bone: chains' tips are seldom side by side.
        /// </summary>
        private const float k_Beyond = 0.1f;

        /// <summary>
        /// Sum of the fan's widths from which on a wing is a fan: the fishfly's fore wing has 0.4, a ribbon of 12:1 has 0.1.
        /// </summary>
        private const float k_FanWidth = 0.4f;

        private readonly RestSkeleton m_Rest;
        private readonly List<Strip> m_Strips = new List<Strip>();
        private readonly List<float> m_Levers = new List<float>();

        /// <param name="rest">The skeleton.</param>
        public StripNetwork(RestSkeleton rest)
        {
            m_Rest = rest;
            for (int joint = 0; joint < rest.joints.Length; joint++)
            {
                int chain = joint / rest.jointsPerChain;
                if (joint == chain * rest.jointsPerChain)
                    continue;
                if (chain > 0)
                    Add(joint, chain - 1);
                if (chain + 1 < rest.chainCount)
                    Add(joint, chain + 1);
            }

            Strips = m_Strips.ToArray();
            Levers = m_Levers.ToArray();
            FanWidths = Widths();
            float fan = 0f;
            foreach (float width in FanWidths)
                fan += width;
            float share = math.min(fan * (1f / k_FanWidth), 1f);
            Spread = share * share;
        }

        /// <summary>Strips, ordered by their joints.</summary>
        public Strip[] Strips { get; }

        /// <summary>
        /// Slope of a strip for a radian of bend: the distance from the bend over the strip's width; negative on the chain of the foot. See
        /// <see cref="Strip.lever"/>.
        /// </summary>
        public float[] Levers { get; }

        /// <summary>
        /// [n − 1] Narrowest strip between a chain and the next one, its width over the distance from the root; infinite where there is
        /// none.
        /// </summary>
        public float[] FanWidths { get; }

        /// <summary>Spread of the chains: 1 for a fan, towards 0 for a ribbon.</summary>
        public float Spread { get; }

        private float[] Widths()
        {
            float[] widths = new float[m_Rest.chainCount - 1];
            for (int i = 0; i < widths.Length; i++)
                widths[i] = float.PositiveInfinity;
            foreach (Strip strip in Strips)
            {
                int between = math.min(strip.bone, strip.other) / (m_Rest.jointsPerChain - 1);
                widths[between] = math.min(widths[between], 1f / Levers[strip.lever]);
            }

            return widths;
        }

        private void Add(int joint, int chain)
        {
            int m = m_Rest.jointsPerChain, root = joint - joint % m;
            if (!Foot(joint, chain, out int inner, out float3 foot))
                return;
            m_Strips.Add(new Strip
            {
                bone = root / m * (m - 1),
                bones = joint - root,
                other = chain * (m - 1),
                others = inner - chain * m + 1,
                lever = m_Levers.Count,
            });
            float width = math.max(math.distance(m_Rest.joints[joint], foot), k_LeastWidth);
            for (int k = root; k < joint; k++)
                m_Levers.Add(math.distance(m_Rest.joints[joint], m_Rest.joints[k]) / width);
            for (int k = chain * m; k <= inner; k++)
                m_Levers.Add(-math.distance(foot, m_Rest.joints[k]) / width);
        }

        // The nearest point of a chain, if the joint stands square to it: beyond a chain's ends a common bend would look like a tear.
        private bool Foot(int joint, int chain, out int inner, out float3 foot)
        {
            int first = chain * m_Rest.jointsPerChain, last = first + m_Rest.jointsPerChain - 2;
            float nearest = float.PositiveInfinity;
            bool square = false;
            inner = first;
            foot = default;
            for (int k = first; k <= last; k++)
            {
                float3 along = m_Rest.joints[k + 1] - m_Rest.joints[k], to = m_Rest.joints[joint] - m_Rest.joints[k];
                float share = math.dot(to, along) / math.lengthsq(along);
                float3 at = m_Rest.joints[k] + along * math.saturate(share);
                float distance = math.distance(at, m_Rest.joints[joint]);
                if (distance >= nearest)
                    continue;
                (nearest, inner, foot) = (distance, k, at);
                square = (share > 0f || k > first) && (share <= 1f + k_Beyond || k < last);
            }

            return square;
        }
    }
}
