using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// One implicit substep y′ = now · y − before · y₋₁ + length · f(y′), lane = wing. Backward Euler has now 1, before 0; BDF2 with
    /// substeps in the ratio w has now (1+w)²/(1+2w), before w²/(1+2w), length dt (1+w)/(1+2w). A wing without a past (w 0) takes one step
    /// of backward Euler.
    /// </summary>
    internal struct ImplicitStep
    {
        /// <summary>
        /// Zero-stability of BDF2 ends at a ratio of 1 + √2; a longer substep after a short one starts its history again.
        /// </summary>
        private const float k_LargestRatio = 2.4f;

        /// <summary>Length of the substep, seconds.</summary>
        public float4 dt;

        /// <summary>Ratio of dt to the substep before; 0 for a wing without a past.</summary>
        public float4 ratio;

        /// <summary>Factor of the rate at the end, seconds.</summary>
        public float4 length;

        /// <summary>Weight of the state at the start.</summary>
        public float4 now;

        /// <summary>Weight of the state one substep earlier, subtracted.</summary>
        public float4 before;

        /// <summary>Makes the next substep of a pack.</summary>
        public static unsafe ImplicitStep Of(in WingPack pack, float4 dt)
        {
            if (pack.options.timeScheme == TimeScheme.BackwardEuler)
                return new ImplicitStep { dt = dt, length = dt, now = 1f, before = 0f };
            float4 ratio = dt * SoaMath.SafeReciprocal(*pack.lastSubstep);
            ratio = math.select(ratio, 0f, ratio > k_LargestRatio);
            float4 inverse = 1f / (1f + 2f * ratio);
            return new ImplicitStep
            {
                dt = dt,
                ratio = ratio,
                length = dt * (1f + ratio) * inverse,
                now = (1f + ratio) * (1f + ratio) * inverse,
                before = ratio * ratio * inverse,
            };
        }

        /// <summary>Past of a vector as the step takes it: now · y − before · y₋₁.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly SoaFloat3 Past(in SoaFloat3 y, in SoaFloat3 earlier) => y * now - earlier * before;
    }
}
