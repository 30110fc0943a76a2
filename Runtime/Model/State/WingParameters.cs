using System;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Parameters that can be tuned on one wing while it beats, in the units of the model: radians, wing lengths, seconds, hertz, and the
    /// wing's own mass as the unit of mass; a preset has them in degrees, metres and kilograms. Ranges and defaults are in <see
    /// cref="WingParameterRange.All"/>.
    /// </summary>
    [Serializable]
    [MovedFrom(true, null, "Alate")]
    public struct WingParameters
    {
        /// <summary>Largest frequency MAX_f of Eq. 6, hertz, 0.1 to 1000; monarch 11.</summary>
        public float maxFrequency;

        /// <summary>Speed u_max of the slope function s(u) (Fig. 5), metres per second, 0.01 to 100; default 2.</summary>
        public float maxSpeed;

        /// <summary>Least value of s(u) in Eq. 6, 0 to 1; default 0.8. <c>Paper</c>: 0, where an insect at rest beats once in five minutes (s(0) = 3·10⁻⁴).</summary>
        public float frequencyFloor;

        /// <summary>Least value of s(u) in Eq. 7, 0 to 1; default 0.5. <c>Paper</c>: 0, where an insect at rest holds its wings still.</summary>
        public float amplitudeFloor;

        /// <summary>
        /// Half amplitude at full drive, radians, x flap, y sweep, z feather, each 0 to π/2. Half of Table 1's MAX_a, which is peak to peak: a monarch's measured
        /// ±60° are Table 1's 120°.
        /// </summary>
        public float3 amplitude;

        /// <summary>
        /// Phase φ* of Eq. 1, radians, x flap, y sweep, z feather, −2π to 2π; default 0, −π/2, −π/2: feather and sweep lead the flap by a
        /// quarter of a beat, so that the wing is edge-on at the turns. <c>Paper</c>: 0 (its Sec. 5.1 starts all three together).
        /// </summary>
        public float3 phase;

        /// <summary>Middle of the flapping stroke above the horizontal, radians, −π/2 to π/2; default 10°.</summary>
        public float meanFlap;

        /// <summary>Tilt of the stroke plane about the span axis, nose up positive, radians, −π/2 to π/2; default 0.</summary>
        public float tilt;

        /// <summary>
        /// Largest delay λ from leading to trailing edge in half beats, 0 to 2; default 0.15. Less where neighbouring chains are too close
        /// to bear it; see <see cref="MembraneCoupling.TwoWay"/>. <c>Paper</c>: 1, Eq. 2 as printed (trailing edge in anti-phase).
        /// </summary>
        public float chordDelay;

        /// <summary>Delay μ from root to tip in half beats, 0 to 2; default 0.1. <c>Paper</c>: 0 (Eq. 2 has no such term).</summary>
        public float spanDelay;

        /// <summary>
        /// Share w_0 of the driven angle that the root turns, 0 to 1; the other joints share the rest evenly; default 0.8.
        /// </summary>
        public float rootShare;

        /// <summary>
        /// Factor κ_in of the beat's own inertia (Eq. 5), 0 to 10; default 1, Newton's law. <c>Paper</c>: 2, the printed factor.
        /// </summary>
        public float inertia;

        /// <summary>
        /// Relative density ρ* = ρL³/m_w: mass of the fluid in a cube of one wing length over the wing's mass, 0 to 10⁵; monarch 11.
        /// </summary>
        public float airDensity;

        /// <summary>
        /// Wind beyond which the wing hardly bends more, over the speed v_ref = 2π f_ref · flap of a wing tip that flies at u_max, 0.1 to 1000; default 0.65, 3.2 m/s for a
        /// monarch. Beyond it the wind is felt as its fourth root, because soft sheets curl up in a stream (Vogel 1989). 1000 takes every wind as it is.
        /// </summary>
        public float strongestWind;

        /// <summary>
        /// Elasticity k_e of Table 2, without unit, 10⁻³ to 10⁶; default 1. Scales bending stiffness and springs together.
        /// </summary>
        public float elasticity;

        /// <summary>
        /// Reference frequency f_ref = MAX_f √(1 + (u_max/v_tip)²), hertz, 0.01 to 10⁵: the rate against which stiffness is measured.
        /// Contains the air speed, because a stiffness that knows the beat alone lets small soft wings flutter in the wind.
        /// </summary>
        public float referenceFrequency;

        /// <summary>Bending frequency N_0 of the leading chain over f_ref, 0.01 to 100; default 5.</summary>
        public float stiffnessRoot;

        /// <summary>Bending frequency N_last of the last chain over f_ref, 0.01 to 100; default 3.5; geometric between both.</summary>
        public float stiffnessTip;

        /// <summary>Span over which the bending stiffness of a chain falls to 1/e, in chain lengths, 0.05 to 100; default 1.</summary>
        public float stiffnessDecay;

        /// <summary>Damping ζ of a bending joint over its critical damping, 0 to 10; default 0.7.</summary>
        public float bendDamping;

        /// <summary>Stiffness against bending up over that against bending down, 0.1 to 10; default 1.4: wings yield more readily on the upstroke.</summary>
        public float dorsalAsymmetry;

        /// <summary>Stiffness in the wing's plane over that out of it, 0 to 1000; default 25.</summary>
        public float inPlaneFactor;

        /// <summary>Stiffness in torsion over that in bending, 0 to 1000; default 1.</summary>
        public float torsionFactor;

        /// <summary>Largest angle of a joint about each of its three axes, radians, 0 to π/2; default 30°.</summary>
        public float jointLimit;

        /// <summary>Stiffness κ of the springs between joints (Eq. 12), 0 to 1000; default 10.</summary>
        public float springScale;

        /// <summary>Rate that pulls the elastic joints to the posed ones, over f_ref, 0 to 100; default 2.</summary>
        public float anchor;

        /// <summary>Damping ζ_E of the elastic deviation, 0 to 10; default 0.3.</summary>
        public float springDamping;

        /// <summary>Substeps of one beat, 12 to 480; default 16. Fast air takes more by itself.</summary>
        public int substepsPerBeat;

        /// <summary>Factor on all three amplitudes, 0 to 2; default 1. For a flight controller that rolls by beating one side harder.</summary>
        public float amplitudeScale;

        /// <summary>Phase by which this wing is ahead of the beat clock, radians, −2π to 2π; default 0. For hind wings that follow their fore wings.</summary>
        public float phaseLead;

        /// <summary>Choices that the paper leaves open.</summary>
        public ModelOptions options;

        /// <summary>A monarch's wing by <see cref="ModelReading.Physical"/>.</summary>
        public static WingParameters Default
        {
            get
            {
                var parameters = new WingParameters { substepsPerBeat = DefaultSubsteps, options = ModelOptions.Physical };
                foreach (var range in WingParameterRange.s_All)
                {
                    range.Of(ref parameters) = range.Default;
                }

                return parameters;
            }
        }

        /// <summary>Bounds of <see cref="substepsPerBeat"/> and its default.</summary>
        public const int MinSubsteps = 12, MaxSubsteps = 480, DefaultSubsteps = 16;

        /// <summary>Parameters with every value moved into its range; a value that is not a number becomes its default.</summary>
        public WingParameters Clamped()
        {
            var clamped = this;
            foreach (var range in WingParameterRange.s_All)
            {
                ref var value = ref range.Of(ref clamped);
                value = range.Clamp(value);
            }

            clamped.substepsPerBeat = math.clamp(substepsPerBeat, MinSubsteps, MaxSubsteps);
            return clamped;
        }

        /// <summary>Returns true where every value is equal.</summary>
        internal bool SameAs(WingParameters other)
        {
            var copy = this;
            foreach (var range in WingParameterRange.s_All)
            {
                if (range.Of(ref copy) != range.Of(ref other))
                {
                    return false;
                }
            }

            return substepsPerBeat == other.substepsPerBeat && options.Equals(other.options);
        }

        /// <summary>
        /// Describes the first value that is not finite or out of its range, as "chordDelay is −1 half beats; it must be between 0 and 2.";
        /// null when all are in range.
        /// </summary>
        public string FindProblem()
        {
            var copy = this;
            foreach (var range in WingParameterRange.s_All)
            {
                var value = range.Of(ref copy);
                if (!range.Contains(value))
                {
                    return range.Describe(value);
                }
            }

            if (substepsPerBeat < MinSubsteps || substepsPerBeat > MaxSubsteps)
            {
                return FormattableString.Invariant(
                    $"substepsPerBeat is {substepsPerBeat}; it must be between {MinSubsteps} and {MaxSubsteps}.");
            }

            return null;
        }
    }
}
