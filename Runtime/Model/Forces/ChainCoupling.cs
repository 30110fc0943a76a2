using System.Runtime.CompilerServices;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Bends neighbouring chains together where bending apart would tear the strip of membrane between them: out of its plane beyond a
    /// slope, in its plane beyond a strain. The hinges' implicit steps are corrected by the strips' forces, which minimise Σ ½ (θ − θ*)²/c
    /// + Σ ½ K max(|s| − s₀, 0)² over all bends θ of the wing, one strip after the other (projected Gauss–Seidel, compliant as in XPBD,
    /// Macklin et al. 2016). Each strip's force acts on both chains alike.
    /// </summary>
    internal static unsafe class ChainCoupling
    {
        /// <summary>
        /// Slope of a strip up to which chains bend freely: at 0.2, gales fold narrow wings; below 0.1 nothing is gained.
        /// </summary>
        private const float k_FreeSlope = 0.1f;

        /// <summary>Strain of a strip in its plane up to which chains bend freely.</summary>
        private const float k_FreeStrain = 0.05f;

        /// <summary>Stiffness K of a strip over that of the bends that it couples.</summary>
        private const float k_Stiffness = 100f;

        /// <summary>
        /// Number of passes over all strips. Four leave the narrowest wings a tenth more stretch; in still air two or three suffice and the
        /// rest is not run.
        /// </summary>
        private const int k_Passes = 8;

        /// <summary>Change of force, as a share of a strip's free slope, below which the passes end.</summary>
        private const float k_Tolerance = 0.1f;

        /// <summary>Corrects bend angles and rates of the pack, after every hinge has moved independently.</summary>
        public static void Apply(in WingPack pack, in StepScratch scratch, in ImplicitStep step)
        {
            var angles = (float4*)pack.bendAngles;
            var rates = (float4*)pack.bendRates;
            var compliances = (float4*)scratch.compliances;
            Couple(pack, scratch, step, angles, rates, compliances, k_FreeSlope, 1f);
            Couple(pack, scratch, step, angles + 1, rates + 1, compliances + 1, k_FreeStrain, pack.parameters->numbers.inPlaneFactor);
        }

        // One axis of all hinges; angles, rates and compliances are components of vectors, three float4 apart.
        private static void Couple(
            in WingPack pack, in StepScratch scratch, in ImplicitStep step, float4* angles, float4* rates, float4* compliances, float free,
            float4 factor)
        {
            bool4 coupled = Begin(pack, scratch, angles, compliances, free, factor), running = coupled;
            if (!math.any(coupled))
                return;
            for (int pass = 0; pass < k_Passes; pass++)
            {
                float4 largest = 0f;
                for (int k = 0; k < pack.rig.stripCount; k++)
                {
                    int strip = (pass & 1) == 0 ? k : pack.rig.stripCount - 1 - k;
                    largest = math.max(largest, Relax(pack, scratch, strip, compliances, free, running));
                }

                running &= largest >= k_Tolerance * free;
                if (!math.any(running))
                    break;
            }

            float4 inverse = 1f / step.length, limit = pack.parameters->numbers.jointLimit;
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
            {
                float4 held = math.min(math.max(scratch.coupledAngles[bone], -limit), limit);
                rates[3 * bone] = math.select(rates[3 * bone], rates[3 * bone] + (held - angles[3 * bone]) * inverse, coupled);
                angles[3 * bone] = math.select(angles[3 * bone], held, coupled);
            }
        }

        // Angles, no forces, and the strips' compliances; returns the wings of which a strip is beyond its free slope, at once where there
        // are none.
        private static bool4 Begin(in WingPack pack, in StepScratch scratch, float4* angles, float4* compliances, float free, float4 factor)
        {
            for (int bone = 0; bone < pack.rig.boneCount; bone++)
                scratch.coupledAngles[bone] = angles[3 * bone];
            float4 steepest = 0f;
            for (int k = 0; k < pack.rig.stripCount; k++)
                steepest = math.max(steepest, math.abs(Slope(pack, scratch, pack.rig.strips + k)));
            bool4 coupled = steepest > free;
            if (!math.any(coupled))
                return coupled;
            for (int k = 0; k < pack.rig.stripCount; k++)
            {
                Strip* strip = pack.rig.strips + k;
                float* lever = pack.rig.stripLevers + strip->lever;
                float4 compliance = 0f;
                for (int b = 0; b < strip->bones; b++)
                    compliance += compliances[3 * (strip->bone + b)] * (lever[b] * lever[b]);
                lever += strip->bones;
                for (int b = 0; b < strip->others; b++)
                    compliance += compliances[3 * (strip->other + b)] * (lever[b] * lever[b]);
                float4 stiffness = k_Stiffness * factor * (pack.bendStiffness[strip->bone] + pack.bendStiffness[strip->other]);
                scratch.stripCompliances[k] = compliance;
                scratch.stripYields[k] = compliance + 2f / (stiffness + 1e-20f);
                scratch.stripForces[k] = 0f;
            }

            return coupled;
        }

        // How the strip is tilted out of its plane, or strained in it, by the bends of both chains on the way to it.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static float4 Slope(in WingPack pack, in StepScratch scratch, Strip* strip)
        {
            float* lever = pack.rig.stripLevers + strip->lever;
            float4 slope = 0f;
            for (int b = 0; b < strip->bones; b++)
                slope += scratch.coupledAngles[strip->bone + b] * lever[b];
            lever += strip->bones;
            for (int b = 0; b < strip->others; b++)
                slope += scratch.coupledAngles[strip->other + b] * lever[b];
            return slope;
        }

        // Of the wings that have not settled yet: brings the force of one strip to where it balances its slope, and turns the hinges by the
        // change. It pulls back, never on.
        private static float4 Relax(in WingPack pack, in StepScratch scratch, int index, float4* compliances, float free, bool4 running)
        {
            Strip* strip = pack.rig.strips + index;
            float4 slope = Slope(pack, scratch, strip), force = scratch.stripForces[index];
            float4 own = scratch.stripCompliances[index];

            // Without this strip the slope would be slope − own · force; its force is what is then beyond the free slope, shared with K.
            float4 unloaded = slope - own * force;
            float4 over = unloaded - math.min(math.max(unloaded, -free), free);
            float4 change = math.select(0f, -over / scratch.stripYields[index] - force, running);
            scratch.stripForces[index] = force + change;
            float* lever = pack.rig.stripLevers + strip->lever;
            for (int b = 0; b < strip->bones; b++)
                scratch.coupledAngles[strip->bone + b] += change * compliances[3 * (strip->bone + b)] * lever[b];
            lever += strip->bones;
            for (int b = 0; b < strip->others; b++)
                scratch.coupledAngles[strip->other + b] += change * compliances[3 * (strip->other + b)] * lever[b];
            return math.abs(change) * own;
        }
    }
}
