using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Rates of the deformation at the end of a substep: the joints moved by their mean rate, which is carried on by half of what it has
    /// changed by.
    /// </summary>
    internal readonly unsafe struct EndRates
    {
        private readonly float4 m_Inverse, m_Ahead;

        public EndRates(in WingPack pack, float4 dt)
        {
            float4 past = *pack.lastSubstep;
            m_Inverse = 1f / dt;
            m_Ahead = math.select(dt / (dt + past), 0f, past <= 0f);
        }

        /// <summary>Velocity of a joint's deformation, L/s; before the pack's motions and poses are those of the new pose.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SoaFloat3 Of(in WingPack pack, in StepScratch scratch, int joint)
        {
            SoaFloat3 moved = scratch.pose[joint].position - pack.pose[joint].position;
            SoaFloat3 mean = (moved - scratch.drivenPositions[joint] + pack.drivenPositions[joint]) * m_Inverse;
            return mean + (mean - pack.motions[joint].velocity) * m_Ahead;
        }
    }
}
