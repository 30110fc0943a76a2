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

        /// <summary>
        /// Least value of s(u) in Eq. 6, 0 to 1; default 0.8. <c>Paper</c>: 0, where an insect at rest beats once in five minutes (s(0) =
        /// 3·10⁻⁴).
        /// </summary>
        public float frequencyFloor;

        /// <summary>
        /// Least value of s(u) in Eq. 7, 0 to 1; default 0.5. <c>Paper</c>: 0, where an insect at rest holds its wings still.
        /// </summary>
        public float amplitudeFloor;

        /// <summary>
        /// Half amplitude at full drive, radians, x flap, y sweep, z feather, each 0 to π/2. Half of Table 1's MAX_a, which is peak to
        /// peak: a monarch's measured ±60° are Table 1's 120°.
        /// </summary>
        public float3 amplitude;

        /// <summary>
        /// Phase φ* of Eq. 1, radians, x flap, y sweep, z feather, −2π to 2π; default 0, −π/2, −π/2: feather and sweep follow the flap by a
        /// quarter of a beat, largest in the middle of the half strokes. <c>Paper</c>: 0 (its Sec. 5.1 starts all three together).
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
        /// Wind beyond which the wing hardly bends more, over the speed v_ref = 2π f_ref · flap of a wing tip that flies at u_max, 0.1 to
        /// 1000; default 0.65, 3.2 m/s for a monarch. Beyond it the wind is felt as its fourth root, because soft sheets curl up in a
        /// stream (Vogel 1989). 1000 takes every wind as it is.
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

        /// <summary>
        /// Stiffness against bending up over that against bending down, 0.1 to 10; default 1.4: wings yield more readily on the upstroke.
        /// </summary>
        public float dorsalAsymmetry;

        /// <summary>
        /// 1 N·m² of measured stiffness (<see cref="JointChain.flexuralStiffness"/>) in wing masses times cubed wing lengths per squared
        /// second, 1/(m_w L³), 0 to 10²⁰; monarch 1.76·10⁸. Chains of unknown stiffness do not read it.
        /// </summary>
        public float stiffnessUnit;

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

        /// <summary>
        /// Factor on all three amplitudes, 0 to 2; default 1. For a flight controller that rolls by beating one side harder.
        /// </summary>
        public float amplitudeScale;

        /// <summary>
        /// Phase by which this wing is ahead of the beat clock, radians, −2π to 2π; default 0. For hind wings that follow their fore wings.
        /// </summary>
        public float phaseLead;

        /// <summary>Choices that the paper leaves open.</summary>
        public ModelOptions options;

        /// <summary>
        /// Motion that is prescribed in place of the waves of Eq. 1; default none. A wing that is given one should be reset.
        /// </summary>
        public WingKinematics kinematics;

        /// <summary>Air that the wake has set moving at the wing, beside the wind; default none. It comes and goes within a beat.</summary>
        public WingInflow inflow;

        /// <summary>A monarch's wing by <see cref="ModelReading.Physical"/>.</summary>
        public static WingParameters Default
        {
            get
            {
                var parameters = new WingParameters { substepsPerBeat = DefaultSubsteps, options = ModelOptions.Physical };
                foreach (WingParameterRange range in s_Ranges)
                    range.Of(ref parameters) = range.Default;

                return parameters;
            }
        }

        /// <summary>Bounds of <see cref="substepsPerBeat"/> and its default.</summary>
        public const int MinSubsteps = 12, MaxSubsteps = 480, DefaultSubsteps = 16;

        /// <summary>Parameters with every value moved into its range; a value that is not a number becomes its default.</summary>
        public WingParameters Clamped()
        {
            WingParameters clamped = this;
            foreach (WingParameterRange range in s_Ranges)
            {
                ref float value = ref range.Of(ref clamped);
                value = range.Clamp(value);
            }

            clamped.substepsPerBeat = math.clamp(substepsPerBeat, MinSubsteps, MaxSubsteps);
            clamped.options = options.Defined();
            if (kinematics.FindProblem() != null)
                clamped.kinematics = default;
            if (inflow.FindProblem() != null)
                clamped.inflow = default;
            return clamped;
        }

        /// <summary>Returns true where every value is equal.</summary>
        internal bool SameAs(WingParameters other)
        {
            WingParameters copy = this;
            foreach (WingParameterRange range in s_Ranges)
            {
                if (range.Of(ref copy) != range.Of(ref other))
                    return false;
            }

            return substepsPerBeat == other.substepsPerBeat && options.Equals(other.options) && kinematics.Equals(other.kinematics)
                && inflow.Equals(other.inflow);
        }

        /// <summary>
        /// Describes the first value that is not finite or out of its range, as "chordDelay is −1 half beats; it must be between 0 and 2.";
        /// null when all are in range.
        /// </summary>
        public string FindProblem()
        {
            WingParameters copy = this;
            foreach (WingParameterRange range in s_Ranges)
            {
                float value = range.Of(ref copy);
                if (!range.Contains(value))
                    return range.Describe(value);
            }

            if (substepsPerBeat < MinSubsteps || substepsPerBeat > MaxSubsteps)
            {
                return FormattableString.Invariant(
                    $"substepsPerBeat is {substepsPerBeat}; it must be between {MinSubsteps} and {MaxSubsteps}.");
            }

            return options.FindProblem() ?? kinematics.FindProblem() ?? inflow.FindProblem();
        }

        /// <summary>Every number, in the order of the fields.</summary>
        internal static readonly WingParameterRange[] s_Ranges =
        {
            new WingParameterRange("maxFrequency", "hertz", WingBounds.MaxFrequency.Min, WingBounds.MaxFrequency.Default,
                WingBounds.MaxFrequency.Max, (ref WingParameters p) => ref p.maxFrequency),
            new WingParameterRange("maxSpeed", "metres per second", WingBounds.MaxSpeed.Min, WingBounds.MaxSpeed.Default,
                WingBounds.MaxSpeed.Max, (ref WingParameters p) => ref p.maxSpeed),
            new WingParameterRange("frequencyFloor", "", WingBounds.FrequencyFloor.Min, WingBounds.FrequencyFloor.Default,
                WingBounds.FrequencyFloor.Max, (ref WingParameters p) => ref p.frequencyFloor),
            new WingParameterRange("amplitudeFloor", "", WingBounds.AmplitudeFloor.Min, WingBounds.AmplitudeFloor.Default,
                WingBounds.AmplitudeFloor.Max, (ref WingParameters p) => ref p.amplitudeFloor),
            WingParameterRange.Angle("amplitude.x", 0.5f * WingBounds.FlapRange.Min, 0.5f * WingBounds.FlapRange.Default,
                0.5f * WingBounds.FlapRange.Max, (ref WingParameters p) => ref p.amplitude.x),
            WingParameterRange.Angle("amplitude.y", 0.5f * WingBounds.SweepRange.Min, 0.5f * WingBounds.SweepRange.Default,
                0.5f * WingBounds.SweepRange.Max, (ref WingParameters p) => ref p.amplitude.y),
            WingParameterRange.Angle("amplitude.z", 0.5f * WingBounds.FeatherRange.Min, 0.5f * WingBounds.FeatherRange.Default,
                0.5f * WingBounds.FeatherRange.Max, (ref WingParameters p) => ref p.amplitude.z),
            WingParameterRange.Angle("phase.x", -360f, WingBounds.FlapPhase.Default, 360f, (ref WingParameters p) => ref p.phase.x),
            WingParameterRange.Angle("phase.y", -360f, WingBounds.SweepPhase.Default, 360f, (ref WingParameters p) => ref p.phase.y),
            WingParameterRange.Angle("phase.z", -360f, WingBounds.FeatherPhase.Default, 360f, (ref WingParameters p) => ref p.phase.z),
            WingParameterRange.Angle("meanFlap", WingBounds.MeanFlap.Min, WingBounds.MeanFlap.Default, WingBounds.MeanFlap.Max,
                (ref WingParameters p) => ref p.meanFlap),
            WingParameterRange.Angle(
                "tilt", WingBounds.Tilt.Min, WingBounds.Tilt.Default, WingBounds.Tilt.Max, (ref WingParameters p) => ref p.tilt),
            new WingParameterRange("chordDelay", "half beats", WingBounds.ChordDelay.Min, WingBounds.ChordDelay.Default,
                WingBounds.ChordDelay.Max, (ref WingParameters p) => ref p.chordDelay),
            new WingParameterRange("spanDelay", "half beats", WingBounds.SpanDelay.Min, WingBounds.SpanDelay.Default,
                WingBounds.SpanDelay.Max, (ref WingParameters p) => ref p.spanDelay),
            new WingParameterRange("rootShare", "", WingBounds.RootShare.Min, WingBounds.RootShare.Default, WingBounds.RootShare.Max,
                (ref WingParameters p) => ref p.rootShare),
            new WingParameterRange("inertia", "", WingBounds.Inertia.Min, WingBounds.Inertia.Default, WingBounds.Inertia.Max,
                (ref WingParameters p) => ref p.inertia),
            new WingParameterRange(
                "airDensity", "wing masses per cubed wing length", 0f, 11.1f, 1e5f, (ref WingParameters p) => ref p.airDensity),
            new WingParameterRange("strongestWind", "", WingBounds.StrongestWind.Min, WingBounds.StrongestWind.Default,
                WingBounds.StrongestWind.Max, (ref WingParameters p) => ref p.strongestWind),
            new WingParameterRange("elasticity", "", WingBounds.Elasticity.Min, WingBounds.Elasticity.Default, WingBounds.Elasticity.Max,
                (ref WingParameters p) => ref p.elasticity),
            new WingParameterRange("referenceFrequency", "hertz", 0.01f, 12.08f, 1e5f, (ref WingParameters p) => ref p.referenceFrequency),
            new WingParameterRange("stiffnessRoot", "", WingBounds.LeadingEdge.Min, WingBounds.LeadingEdge.Default,
                WingBounds.LeadingEdge.Max, (ref WingParameters p) => ref p.stiffnessRoot),
            new WingParameterRange("stiffnessTip", "", WingBounds.TrailingEdge.Min, WingBounds.TrailingEdge.Default,
                WingBounds.TrailingEdge.Max, (ref WingParameters p) => ref p.stiffnessTip),
            new WingParameterRange("stiffnessDecay", "chain lengths", WingBounds.Decay.Min, WingBounds.Decay.Default, WingBounds.Decay.Max,
                (ref WingParameters p) => ref p.stiffnessDecay),
            new WingParameterRange("bendDamping", "", WingBounds.Damping.Min, WingBounds.Damping.Default, WingBounds.Damping.Max,
                (ref WingParameters p) => ref p.bendDamping),
            new WingParameterRange("dorsalAsymmetry", "", WingBounds.DorsalAsymmetry.Min, WingBounds.DorsalAsymmetry.Default,
                WingBounds.DorsalAsymmetry.Max, (ref WingParameters p) => ref p.dorsalAsymmetry),
            new WingParameterRange("stiffnessUnit", "wing masses times cubed wing lengths per squared second", 0f, 1.755e8f, 1e20f,
                (ref WingParameters p) => ref p.stiffnessUnit),
            new WingParameterRange("inPlaneFactor", "", WingBounds.InPlaneFactor.Min, WingBounds.InPlaneFactor.Default,
                WingBounds.InPlaneFactor.Max, (ref WingParameters p) => ref p.inPlaneFactor),
            new WingParameterRange("torsionFactor", "", WingBounds.TorsionFactor.Min, WingBounds.TorsionFactor.Default,
                WingBounds.TorsionFactor.Max, (ref WingParameters p) => ref p.torsionFactor),
            WingParameterRange.Angle("jointLimit", WingBounds.JointLimit.Min, WingBounds.JointLimit.Default, WingBounds.JointLimit.Max,
                (ref WingParameters p) => ref p.jointLimit),
            new WingParameterRange("springScale", "", WingBounds.SpringScale.Min, WingBounds.SpringScale.Default,
                WingBounds.SpringScale.Max, (ref WingParameters p) => ref p.springScale),
            new WingParameterRange("anchor", "", WingBounds.Anchor.Min, WingBounds.Anchor.Default, WingBounds.Anchor.Max,
                (ref WingParameters p) => ref p.anchor),
            new WingParameterRange("springDamping", "", WingBounds.SpringDamping.Min, WingBounds.SpringDamping.Default,
                WingBounds.SpringDamping.Max, (ref WingParameters p) => ref p.springDamping),
            new WingParameterRange("amplitudeScale", "", 0f, 1f, 2f, (ref WingParameters p) => ref p.amplitudeScale),
            WingParameterRange.Angle("phaseLead", -360f, WingBounds.PhaseLead.Default, 360f, (ref WingParameters p) => ref p.phaseLead),
        };
    }

    /// <summary>
    /// Bounds of each number that a preset has, and a monarch's value, in the preset's units: degrees, hertz, metres, kilograms.
    /// </summary>
    internal static class WingBounds
    {
        public static class WingLength { public const float Min = 5e-4f, Default = 0.061f, Max = 1f; }
        public static class WingMass { public const float Min = 1e-9f, Default = 25.1e-6f, Max = 1f; }
        public static class InsectMass { public const float Min = 1e-8f, Default = 0.428e-3f, Max = 10f; }
        public static class FluidDensity { public const float Min = 0f, Default = 1.225f, Max = 2000f; }
        public static class GravityShare { public const float Min = 0f, Default = 1f, Max = 1f; }
        public static class MaxFrequency { public const float Min = 0.1f, Default = 11f, Max = 1000f; }
        public static class MaxSpeed { public const float Min = 0.01f, Default = 2f, Max = 100f; }
        public static class FrequencyFloor { public const float Min = 0f, Default = 0.8f, Max = 1f; }
        public static class AmplitudeFloor { public const float Min = 0f, Default = 0.5f, Max = 1f; }
        public static class FlapRange { public const float Min = 0f, Default = 120f, Max = 180f; }
        public static class FeatherRange { public const float Min = 0f, Default = 24f, Max = 180f; }
        public static class SweepRange { public const float Min = 0f, Default = 36f, Max = 180f; }
        public static class FlapPhase { public const float Min = -180f, Default = 0f, Max = 180f; }
        public static class FeatherPhase { public const float Min = -180f, Default = -90f, Max = 180f; }
        public static class SweepPhase { public const float Min = -180f, Default = -90f, Max = 180f; }
        public static class MeanFlap { public const float Min = -90f, Default = 10f, Max = 90f; }
        public static class Tilt { public const float Min = -90f, Default = 0f, Max = 90f; }
        public static class PhaseLead { public const float Min = -180f, Default = 0f, Max = 180f; }
        // A trailing edge is expected to lag by 10 to 40°, not by Eq. 2's half beat.
        public static class ChordDelay { public const float Min = 0f, Default = 0.15f, Max = 2f; }
        public static class SpanDelay { public const float Min = 0f, Default = 0.1f, Max = 2f; }
        public static class RootShare { public const float Min = 0f, Default = 0.8f, Max = 1f; }
        public static class Inertia { public const float Min = 0f, Default = 1f, Max = 10f; }
        public static class Elasticity { public const float Min = 1e-3f, Default = 1f, Max = 1e6f; }
        public static class LeadingEdge { public const float Min = 0.01f, Default = 5f, Max = 100f; }
        public static class TrailingEdge { public const float Min = 0.01f, Default = 3.5f, Max = 100f; }
        public static class Decay { public const float Min = 0.05f, Default = 1f, Max = 100f; }
        public static class Damping { public const float Min = 0f, Default = 0.7f, Max = 10f; }
        public static class DorsalAsymmetry { public const float Min = 0.1f, Default = 1.4f, Max = 10f; }
        public static class InPlaneFactor { public const float Min = 0f, Default = 25f, Max = 1000f; }
        public static class TorsionFactor { public const float Min = 0f, Default = 1f, Max = 1000f; }
        public static class JointLimit { public const float Min = 0f, Default = 30f, Max = 90f; }
        public static class SpringScale { public const float Min = 0f, Default = 10f, Max = 1000f; }
        public static class Anchor { public const float Min = 0f, Default = 2f, Max = 100f; }
        public static class SpringDamping { public const float Min = 0f, Default = 0.3f, Max = 10f; }
        // Up to it wings bend freely; chosen so that no edge tears in ten times that wind.
        public static class StrongestWind { public const float Min = 0.1f, Default = 0.65f, Max = 1000f; }
    }
}
