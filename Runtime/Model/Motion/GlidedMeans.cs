using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Middle of the stroke and tilt: those of the parameters at once, what a flight controller commands glided from the last beat's over
    /// the first half of this one, with its rates, so that the drive stays smooth.
    /// </summary>
    internal static unsafe class GlidedMeans
    {
        private const float k_InversePi = 1f / math.PI;

        /// <summary>Fills the scratch's means.</summary>
        public static void Evaluate(in WingPack pack, in StepScratch scratch)
        {
            ref readonly BeatState beat = ref *pack.beat;
            float4 x = math.min(beat.phase * k_InversePi, 1f);
            SoaFloat3 rise = beat.means - beat.means1;
            SoaFloat3 now = beat.means1 + rise * (x * x * (3f - 2f * x));
            SoaFloat3 rate = rise * (6f * k_InversePi * x * (1f - x));
            float4 bent = math.select(k_InversePi * k_InversePi * (6f - 12f * x), 0f, (x <= 0f) | (x >= 1f));
            SoaFloat3 curvature = rise * bent;

            StrokeMeans* means = scratch.means;
            float4 turn = -(pack.parameters->tilt + now.x);
            SoaMath.SinCos(turn, out means->tiltSin, out means->tiltCos);
            SoaMath.SinCos(0.5f * turn, out means->tiltHalfSin, out means->tiltHalfCos);
            means->tiltRate = -rate.x;
            means->tiltCurvature = -curvature.x;
            float4 raised = beat.meanFlap - beat.meanFlap1, share = x * x * (3f - 2f * x);
            means->angle = new SoaFloat3(pack.parameters->numbers.meanFlap + beat.meanFlap1 + raised * share, now.y, now.z);
            means->rate = new SoaFloat3(raised * (6f * k_InversePi * x * (1f - x)), rate.y, rate.z);
            means->curvature = new SoaFloat3(raised * bent, curvature.y, curvature.z);
        }
    }
}
