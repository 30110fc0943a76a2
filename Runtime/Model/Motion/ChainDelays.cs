using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Delay of each chain behind the leading one (Eq. 2). Where two chains are so near each other that their delay would shear the strip
    /// between them beyond a slope, the excess goes to the strips that have room, so that a membrane can take the driven pose. An excess
    /// for which no strip has room counts by its logarithm: a longer delay always twists the wing more.
    /// </summary>
    internal static unsafe class ChainDelays
    {
        /// <summary>
        /// Slope of a strip while its chains are apart by their delay, at the flap of the preset: steering changes no delay, which would
        /// make the wing jump. 0.65 leaves the monarch (0.69) nearly as printed; the lichen moth's first strip would have 1.1, the
        /// fishfly's last one 0.9.
        /// </summary>
        private const float k_LargestSlope = 0.65f;

        /// <summary>Factor on the logarithm of the excess for which no strip has room.</summary>
        private const float k_Beyond = 0.5f;

        /// <summary>Least flap by which slopes are computed, radians: the delays of a wing that hardly flaps stay finite.</summary>
        private const float k_LeastFlap = 1e-3f;

        /// <summary>Fills the delays of the pack from its parameters.</summary>
        public static void Derive(in WingPack pack)
        {
            float4 whole = pack.parameters->chordDelay;
            float* ratio = pack.rig.chainRatio;
            int strips = pack.rig.chainCount - 1;
            float4 excess = 0f, room = 0f, sum = 0f;
            for (int i = 0; i < strips; i++)
            {
                float4 wanted = whole * (ratio[i + 1] - ratio[i]), most = Most(pack, i, wanted);
                excess += math.max(wanted - most, 0f);
                room += math.max(most - wanted, 0f);
                sum += most;
            }

            float4 share = math.min(excess * SoaMath.SafeReciprocal(room), 1f);
            float4 beyond = 1f + k_Beyond * SoaMath.Log(math.max(whole * SoaMath.SafeReciprocal(sum), 1f));
            float4 delay = 0f;
            pack.chainDelays[0] = 0f;
            for (int i = 0; i < strips; i++)
            {
                float4 wanted = whole * (ratio[i + 1] - ratio[i]), most = Most(pack, i, wanted);
                delay += (math.min(wanted, most) + share * math.max(most - wanted, 0f)) * beyond;
                pack.chainDelays[i + 1] = delay;
            }
        }

        private static float4 Most(in WingPack pack, int strip, float4 wanted)
        {
            float width = pack.rig.fanWidths[strip];
            bool any = pack.options.coupling == MembraneCoupling.OneWay || float.IsInfinity(width);
            return any ? wanted : k_LargestSlope * pack.rig.spread * width / math.max(pack.parameters->wholeFlap, k_LeastFlap);
        }
    }
}
