using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Angles of wings whose motion is prescribed, in place of those of <see cref="DelayedWaves"/>, with their first and second
    /// derivatives.
    /// </summary>
    internal static unsafe class PrescribedMotion
    {
        private const int k_Tilt = (int)DrivenAngle.Tilt;

        /// <summary>Overwrites angles and tilt of the wings with a prescribed motion; does nothing where there are none.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            bool4 lanes = pack.parameters->prescribedFrequency > 0f;
            if (!math.any(lanes))
                return;
            Tilt(pack, scratch, lanes);
            ref readonly LaneParameters parameters = ref *pack.parameters;
            float4 phase = pack.beat->phase, waves = parameters.prescribedWaves;
            int bonesPerChain = pack.rig.jointsPerChain - 1;
            for (int i = 0, bone = 0; i < pack.rig.chainCount; i++)
            {
                for (int j = 0; j < bonesPerChain; j++, bone++)
                {
                    float4 along = phase - waves * parameters.spanDelay * pack.rig.jointRatio[j];
                    float4 delayed = along - waves * pack.chainDelays[i];
                    Series(pack, 0, delayed, out float4 flap, out float4 flapRate, out float4 flapCurvature);
                    // A membrane cannot be sheared in its own plane: all chains sweep as the leading one does.
                    Series(pack, 1, along, out float4 sweep, out float4 sweepRate, out float4 sweepCurvature);
                    Series(pack, 2, delayed, out float4 feather, out float4 featherRate, out float4 featherCurvature);
                    Write(scratch.angle + bone, flap, sweep, feather, lanes);
                    Write(scratch.angleRate + bone, flapRate, sweepRate, featherRate, lanes);
                    Write(scratch.angleCurvature + bone, flapCurvature, sweepCurvature, featherCurvature, lanes);
                }
            }
        }

        /// <summary>
        /// Mean + Σ (c_k cos kp + s_k sin kp) of one series with both derivatives; sines and cosines of kp by the addition theorem.
        /// </summary>
        public static void Series(in WingPack pack, int angle, float4 phase, out float4 value, out float4 rate, out float4 curvature)
        {
            float4* terms = pack.series + angle * WingKinematics.Stride;
            SoaMath.SinCos(phase, out float4 sin1, out float4 cos1);
            float4 sin = sin1, cos = cos1;
            value = terms[0];
            rate = curvature = 0f;
            for (int k = 1; k <= WingKinematics.Harmonics; k++)
            {
                float4 a = terms[2 * k - 1], b = terms[2 * k];
                float4 wave = a * cos + b * sin;
                value += wave;
                rate += k * (b * cos - a * sin);
                curvature -= k * k * wave;
                float4 next = cos * cos1 - sin * sin1;
                sin = sin * cos1 + cos * sin1;
                cos = next;
            }
        }

        private static void Tilt(in WingPack pack, in StepScratch scratch, bool4 lanes)
        {
            Series(pack, k_Tilt, pack.beat->phase, out float4 tilt, out float4 rate, out float4 curvature);
            SoaMath.SinCos(-tilt, out float4 sin, out float4 cos);
            SoaMath.SinCos(-0.5f * tilt, out float4 halfSin, out float4 halfCos);
            StrokeMeans* means = scratch.means;
            means->tiltSin = math.select(means->tiltSin, sin, lanes);
            means->tiltCos = math.select(means->tiltCos, cos, lanes);
            means->tiltHalfSin = math.select(means->tiltHalfSin, halfSin, lanes);
            means->tiltHalfCos = math.select(means->tiltHalfCos, halfCos, lanes);
            means->tiltRate = math.select(means->tiltRate, -rate, lanes);
            means->tiltCurvature = math.select(means->tiltCurvature, -curvature, lanes);
        }

        private static void Write(SoaFloat3* target, float4 flap, float4 sweep, float4 feather, bool4 lanes) =>
            *target = SoaFloat3.Select(*target, new SoaFloat3(flap, sweep, feather), lanes);
    }
}
