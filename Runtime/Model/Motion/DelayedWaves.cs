using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Eq. 1–3: flap, sweep and feather as cosine waves that reach each chain and joint with a delay, with their first and second
    /// derivatives with respect to the phase. Several passes over small arrays: each stays small enough to be compiled without calls.
    /// </summary>
    internal static unsafe class DelayedWaves
    {
        private const float k_TwoPi = 2f * math.PI;
        private const float k_InversePi = 1f / math.PI;

        /// <summary>
        /// Fills angle, angleRate and angleCurvature of every bone: cumulative along its chain; derivatives per radian of Φ.
        /// </summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            GlidedMeans.Evaluate(pack, scratch);
            LocalPhases(pack, scratch);
            Waves(pack, scratch);
            Accumulate(pack, scratch);
            SweepTogether(pack, scratch);
            PrescribedMotion.Evaluate(pack, scratch);
        }

        /// <summary>
        /// Number of bones with a sweep of their own, the first ones: those of the leading chain where all others sweep as it does.
        /// </summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static int SweepCount(in WingPack pack) =>
            pack.options.coupling == MembraneCoupling.TwoWay ? pack.rig.jointsPerChain - 1 : pack.rig.boneCount;

        // Eq. 2 as a phase δ_ij = δ_i + μπσ_j, the chain's delay by ChainDelays, and the Heaviside of Eq. 3: the local phase goes back into
        // earlier cycles, and stands at the start of the first one until the wave arrives.
        private static void LocalPhases(in WingPack pack, in StepScratch scratch)
        {
            ref readonly LaneParameters parameters = ref *pack.parameters;
            ref readonly BeatState beat = ref *pack.beat;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int i = 0, bone = 0; i < pack.rig.chainCount; i++)
            {
                float4 chainPhase = beat.phase - parameters.wingDelay - pack.chainDelays[i];
                for (int j = 0; j < bonesPerChain; j++, bone++)
                {
                    float4 p = chainPhase - parameters.spanDelay * pack.rig.jointRatio[j];
                    SoaFloat3 now = beat.amplitude;
                    SoaFloat3 before = beat.amplitude1;
                    if (GoBack(ref p, ref now, ref before, beat.cycles, 1f, beat.amplitude1, beat.amplitude2)
                        && GoBack(ref p, ref now, ref before, beat.cycles, 2f, beat.amplitude2, beat.amplitude3))
                    {
                        GoBack(ref p, ref now, ref before, beat.cycles, 3f, beat.amplitude3, beat.amplitude4);
                    }

                    scratch.localPhase[bone] = p;
                    Envelope(pack.options.cycleChange, scratch, bone, p, now, before);
                }
            }
        }

        // Takes the wings whose phase is negative into the cycle before, where they have had one; false where none has.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static bool GoBack(
            ref float4 p, ref SoaFloat3 now, ref SoaFloat3 before, float4 cycles, float least, in SoaFloat3 amplitude, in SoaFloat3 earlier)
        {
            bool4 back = (p < 0f) & (cycles >= least);
            if (!math.any(back))
                return false;
            p = math.select(p, p + k_TwoPi, back);
            now = SoaFloat3.Select(now, amplitude, back);
            before = SoaFloat3.Select(before, earlier, back);
            return true;
        }

        // Amplitude of its own cycle: glides from the last cycle's over the first half, or steps.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Envelope(
            CycleChange change, in StepScratch scratch, int bone, float4 p, SoaFloat3 now, SoaFloat3 before)
        {
            if (change == CycleChange.Step)
            {
                scratch.amplitude[bone] = now;
                scratch.amplitudeRate[bone] = default;
                scratch.amplitudeCurvature[bone] = default;
                return;
            }

            float4 x = math.min(math.max(p * k_InversePi, 0f), 1f);
            SoaFloat3 rise = now - before;
            scratch.amplitude[bone] = before + rise * (x * x * (3f - 2f * x));
            scratch.amplitudeRate[bone] = rise * (6f * k_InversePi * x * (1f - x));
            float4 curvature = k_InversePi * k_InversePi * (6f - 12f * x);
            scratch.amplitudeCurvature[bone] = rise * math.select(curvature, 0f, (p <= 0f) | (p >= math.PI));
        }

        // Eq. 1: θ = A cos(p + φ) with both derivatives, where A varies too.
        private static void Waves(in WingPack pack, in StepScratch scratch)
        {
            SoaFloat3 phaseCos = pack.parameters->phaseCos;
            SoaFloat3 phaseSin = pack.parameters->phaseSin;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                float4 p = scratch.localPhase[bone];
                float4 moving = math.select(1f, 0f, p < 0f);
                SoaMath.SinCos(math.max(p, 0f), out float4 sin, out float4 cos);
                Wave(scratch, bone, moving, phaseCos * cos - phaseSin * sin, phaseCos * sin + phaseSin * cos);
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Wave(in StepScratch scratch, int bone, float4 moving, SoaFloat3 cos, SoaFloat3 sin)
        {
            SoaFloat3 a = scratch.amplitude[bone];
            SoaFloat3 rate = scratch.amplitudeRate[bone];
            SoaFloat3 curvature = scratch.amplitudeCurvature[bone];
            scratch.angle[bone] = Times(a, cos);
            scratch.angleRate[bone] = (Times(rate, cos) - Times(a, sin)) * moving;
            scratch.angleCurvature[bone] = (Times(curvature, cos) - Times(rate + rate, sin) - Times(a, cos)) * moving;
        }

        // The angle at a joint is the sum over the joints from the root, the root taking its own share: all of the sweep where the chains
        // do not spread.
        private static void Accumulate(in WingPack pack, in StepScratch scratch)
        {
            bool coupled = pack.options.coupling == MembraneCoupling.TwoWay;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            float even = 1f / (bonesPerChain - 1);
            float4 rootShare = pack.parameters->numbers.rootShare;
            float4 free = 1f - rootShare, freeSweep = free * (coupled ? pack.rig.spread : 1f);
            for (int first = 0; first < pack.rig.boneCount; first += bonesPerChain)
            {
                var share = new SoaFloat3(rootShare, 1f - freeSweep, rootShare);
                SoaFloat3 angle = scratch.means->angle, rate = scratch.means->rate, curvature = scratch.means->curvature;
                float sum = 0f;
                for (int bone = first; bone < first + bonesPerChain; bone++)
                {
                    float next = coupled ? pack.rig.flapShares[bone] : (bone - first) * even;
                    share += new SoaFloat3(free, freeSweep, free) * (next - sum);
                    sum = next;
                    angle += Times(scratch.angle[bone], share);
                    rate += Times(scratch.angleRate[bone], share);
                    curvature += Times(scratch.angleCurvature[bone], share);
                    scratch.angle[bone] = angle;
                    scratch.angleRate[bone] = rate;
                    scratch.angleCurvature[bone] = curvature;
                    share = default;
                }
            }
        }

        // A membrane cannot be sheared in its own plane: all chains sweep as the leading one does.
        private static void SweepTogether(in WingPack pack, in StepScratch scratch)
        {
            int own = SweepCount(pack);
            for (int bone = own; bone < pack.rig.boneCount; bone++)
            {
                int leading = bone % own;
                scratch.angle[bone].y = scratch.angle[leading].y;
                scratch.angleRate[bone].y = scratch.angleRate[leading].y;
                scratch.angleCurvature[bone].y = scratch.angleCurvature[leading].y;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static SoaFloat3 Times(SoaFloat3 a, SoaFloat3 b) => new SoaFloat3(a.x * b.x, a.y * b.y, a.z * b.z);
    }
}
