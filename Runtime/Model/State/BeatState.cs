using Unity.Mathematics;

namespace Alate
{
    /// <summary>State of the beat of four wings; lane = wing (Eq. 6–7: frequency and amplitude change per cycle).</summary>
    /// <remarks>
    /// 116 bytes a wing: all that changes once a beat, in one piece, which a wing takes with it to another pack.
    /// </remarks>
    internal struct BeatState
    {
        /// <summary>Phase Φ, radians, [0, 2π).</summary>
        public float4 phase;

        /// <summary>Cycles completed since the reset.</summary>
        public float4 cycles;

        /// <summary>Latched frequency of this cycle, Hz.</summary>
        public float4 frequency;

        /// <summary>Latched frequency of the cycle before, Hz.</summary>
        public float4 previousFrequency;

        /// <summary>1 while the body is pitched up beyond the threshold of Eq. 6–7 (with hysteresis), else 0.</summary>
        public float4 pitchedUp;

        /// <summary>Latched half amplitudes of this cycle: flap, sweep, feather, radians.</summary>
        public SoaFloat3 amplitude;

        /// <summary>Amplitudes one cycle back.</summary>
        public SoaFloat3 amplitude1;

        /// <summary>Amplitudes two cycles back.</summary>
        public SoaFloat3 amplitude2;

        /// <summary>Amplitudes three cycles back.</summary>
        public SoaFloat3 amplitude3;

        /// <summary>
        /// Amplitudes four cycles back: the largest delays reach three cycles back, where the amplitude glides from the one before.
        /// </summary>
        public SoaFloat3 amplitude4;

        /// <summary>Latched means of the commanded drive in this cycle, radians: x tilt, y sweep, z feather.</summary>
        public SoaFloat3 means;

        /// <summary>Means one cycle back.</summary>
        public SoaFloat3 means1;

        /// <summary>Latched mean flap of the commanded drive in this cycle and one cycle back, radians.</summary>
        public float4 meanFlap, meanFlap1;

        /// <summary>ω, the angular rate of the phase now, rad/s.</summary>
        public float4 rate;

        /// <summary>Takes over the phase, cycle and frequency of another wing, but not its amplitudes.</summary>
        public void TakeClock(int lane, in BeatState from, int fromLane)
        {
            phase[lane] = from.phase[fromLane];
            cycles[lane] = from.cycles[fromLane];
            frequency[lane] = from.frequency[fromLane];
            previousFrequency[lane] = from.previousFrequency[fromLane];
            pitchedUp[lane] = from.pitchedUp[fromLane];
            rate[lane] = from.rate[fromLane];
        }
    }
}
