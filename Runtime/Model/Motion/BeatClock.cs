using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Advances the beat and latches frequency and amplitude at the start of each cycle (Eq. 6, Eq. 7).</summary>
    internal static class BeatClock
    {
        /// <summary>Pitch above which an insect beats hard, radians (Eq. 6–7).</summary>
        public const float PitchThreshold = math.PI / 6f;

        /// <summary>Least share of the maximum while pitched up (Eq. 6–7).</summary>
        public const float PitchedShare = 0.85f;

        /// <summary>
        /// Half width of the band around the threshold in which the state of being pitched up does not change, so that it does not flicker:
        /// 2°.
        /// </summary>
        private const float k_PitchHysteresis = 2f * math.PI / 180f;

        private const float k_TwoPi = 2f * math.PI;

        /// <summary>Slope shape function of Fig. 5, s(u) = 1 / (1 + exp(−16 (|u|/u_max − ½))).</summary>
        /// <param name="relativeSpeed">|u| / u_max.</param>
        public static float4 Slope(float4 relativeSpeed) => 1f / (1f + SoaMath.Exp(-16f * (relativeSpeed - 0.5f)));

        /// <summary>Puts the chosen wings at the start of their first cycle.</summary>
        public static void Reset(ref BeatState beat, in LaneParameters parameters, in LaneSurroundings air, bool4 lanes)
        {
            beat.pitchedUp = math.select(beat.pitchedUp, 0f, lanes);
            Drive(ref beat, parameters, air, lanes, out float4 frequency, out SoaFloat3 amplitude);
            beat.phase = math.select(beat.phase, 0f, lanes);
            beat.cycles = math.select(beat.cycles, 0f, lanes);
            beat.frequency = math.select(beat.frequency, frequency, lanes);
            beat.previousFrequency = math.select(beat.previousFrequency, frequency, lanes);
            beat.rate = math.select(beat.rate, k_TwoPi * frequency, lanes);
            beat.amplitude = SoaFloat3.Select(beat.amplitude, amplitude, lanes);
            beat.amplitude1 = SoaFloat3.Select(beat.amplitude1, amplitude, lanes);
            beat.amplitude2 = SoaFloat3.Select(beat.amplitude2, amplitude, lanes);
            beat.amplitude3 = SoaFloat3.Select(beat.amplitude3, amplitude, lanes);
            beat.amplitude4 = SoaFloat3.Select(beat.amplitude4, amplitude, lanes);
            beat.means = SoaFloat3.Select(beat.means, parameters.drive.means, lanes);
            beat.means1 = SoaFloat3.Select(beat.means1, parameters.drive.means, lanes);
            beat.meanFlap = math.select(beat.meanFlap, parameters.drive.meanFlap, lanes);
            beat.meanFlap1 = math.select(beat.meanFlap1, parameters.drive.meanFlap, lanes);
        }

        /// <summary>
        /// Advances the phase by one substep; a wing that completes its cycle latches the body's current speed and pitch.
        /// </summary>
        public static void Advance(ref BeatState beat, in LaneParameters parameters, in LaneSurroundings air, CycleChange change, float4 dt)
        {
            beat.rate = Rate(beat, change);
            beat.phase += beat.rate * dt;
            bool4 latch = beat.phase >= k_TwoPi;
            if (!math.any(latch))
                return;

            Drive(ref beat, parameters, air, latch, out float4 frequency, out SoaFloat3 amplitude);
            beat.phase = math.select(beat.phase, beat.phase - k_TwoPi, latch);
            beat.cycles += math.select(0f, 1f, latch);
            beat.previousFrequency = math.select(beat.previousFrequency, beat.frequency, latch);
            beat.frequency = math.select(beat.frequency, frequency, latch);
            beat.amplitude4 = SoaFloat3.Select(beat.amplitude4, beat.amplitude3, latch);
            beat.amplitude3 = SoaFloat3.Select(beat.amplitude3, beat.amplitude2, latch);
            beat.amplitude2 = SoaFloat3.Select(beat.amplitude2, beat.amplitude1, latch);
            beat.amplitude1 = SoaFloat3.Select(beat.amplitude1, beat.amplitude, latch);
            beat.amplitude = SoaFloat3.Select(beat.amplitude, amplitude, latch);
            beat.means1 = SoaFloat3.Select(beat.means1, beat.means, latch);
            beat.means = SoaFloat3.Select(beat.means, parameters.drive.means, latch);
            beat.meanFlap1 = math.select(beat.meanFlap1, beat.meanFlap, latch);
            beat.meanFlap = math.select(beat.meanFlap, parameters.drive.meanFlap, latch);
        }

        /// <summary>ω(Φ): glides from the last cycle's frequency to this one's over the first half cycle, or steps.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Rate(in BeatState beat, CycleChange change)
        {
            if (change == CycleChange.Step)
                return k_TwoPi * beat.frequency;
            float4 blend = SoaMath.Smooth(beat.phase * (1f / math.PI));
            return k_TwoPi * (beat.previousFrequency + (beat.frequency - beat.previousFrequency) * blend);
        }

        // Eq. 6 and Eq. 7, or what a controller commands, for the wings that are at the start of a cycle; the others' results are not read.
        private static void Drive(
            ref BeatState beat, in LaneParameters parameters, in LaneSurroundings air, bool4 lanes,
            out float4 frequency, out SoaFloat3 amplitude)
        {
            float4 pitchedUp = math.select(beat.pitchedUp, 1f, air.pitch > PitchThreshold + k_PitchHysteresis);
            pitchedUp = math.select(pitchedUp, 0f, air.pitch < PitchThreshold - k_PitchHysteresis);
            beat.pitchedUp = math.select(beat.pitchedUp, pitchedUp, lanes);

            float4 slope = math.max(Slope(air.speed / parameters.numbers.maxSpeed), PitchedShare * beat.pitchedUp);
            bool4 commanded = parameters.drive.commanded > 0f;
            frequency = math.select(parameters.numbers.maxFrequency * math.max(slope, parameters.numbers.frequencyFloor),
                parameters.drive.frequency, commanded);
            frequency = math.select(frequency, parameters.prescribedFrequency, (parameters.prescribedFrequency > 0f) & !commanded);
            amplitude = parameters.amplitude * math.select(
                math.max(slope, parameters.numbers.amplitudeFloor), parameters.drive.amplitude, commanded);
        }
    }
}
