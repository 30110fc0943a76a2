using System;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Choices where the printed equations leave one open, or where following them to the letter breaks the wing: each is one option here,
    /// and each option's own page gives the reason.
    /// </summary>
    [Serializable]
    [MovedFrom(true, null, "Alate")]
    public struct ModelOptions : IEquatable<ModelOptions>
    {
        /// <summary>Lift and drag coefficients (Fig. 6).</summary>
        [Tooltip("Lift and drag against the angle of attack. Dickinson 1999 was measured on a model fly wing; Paper is Fig. 6; Flat Plate "
            + "suits water and fins.")]
        public CoefficientSet coefficients;

        /// <summary>Tangent against which the angle of attack is measured (Eq. 10).</summary>
        [Tooltip("Chordwise: only flow across the span counts. Base To Tip: as printed; nearly all drag in hover.")]
        public AirTangent tangent;

        /// <summary>
        /// True where a negative lift coefficient counts as zero. Only <see cref="CoefficientSet.Paper"/> ever goes below zero (under
        /// 3.9°), where it would push the wing against the flow. True in both readings.
        /// </summary>
        [Tooltip("Counts a negative lift coefficient as zero. Only the Paper coefficients go below zero, under 3.9 degrees.")]
        public bool clampLift;

        /// <summary>Transition of frequency and amplitude between cycles (Eq. 6, 7).</summary>
        [Tooltip("Smooth: over half a beat. Step: at once, as printed.")]
        public CycleChange cycleChange;

        /// <summary>Loads that turn a joint (Eq. 4).</summary>
        [Tooltip("Distal Joints: everything farther out bends the joint. Own Load About Root: as printed.")]
        public TorqueArm torqueArm;

        /// <summary>Unit of k_e in the springs (Eq. 12).</summary>
        [Tooltip("Beat Rate: the springs keep pace with the beat. Printed: k_e alone, far too soft to matter.")]
        public SpringUnits springUnits;

        /// <summary>Resistance of the membrane to being torn.</summary>
        [Tooltip("Two Way: neighbouring chains bend together before the membrane tears. One Way: as printed; wings tear in wind.")]
        public MembraneCoupling coupling;

        /// <summary>Scheme by which time advances (Eq. 13).</summary>
        [Tooltip(
            "Second Order: the error falls with the square of the substep. Backward Euler: as printed; needs about twice the substeps.")]
        public TimeScheme timeScheme;

        /// <summary>
        /// True where the air that a thin wing carries along, where it is accelerated across its surface, adds to the force of the air and
        /// to the inertia of the joints. False in both readings: the paper has no such term.
        /// </summary>
        [Tooltip("Adds the mass of the air that the wing carries along where it is accelerated across its surface. Off by default.")]
        public bool addedMass;

        /// <summary>
        /// True where the inertia of beating wings moves the body that they carry, in flight alone. False in both readings: the paper's
        /// bodies follow given trajectories.
        /// </summary>
        [Tooltip("In flight: the inertia of the beating wings moves the body. Trims of its own are to be baked for it. Off by default.")]
        public bool bodyReaction;

        /// <summary>
        /// True where a wing that turns about its span meets the air of its three-quarter chord, as far as the flow is attached (cos² of
        /// the angle of attack): the rotational lift of Kramer 1932, Sane and Dickinson 2002. False in both readings.
        /// </summary>
        [Tooltip("Adds the lift of a wing that turns about its span, as far as the flow is attached. Off by default.")]
        public bool attachedRotation;

        /// <summary>The options of <see cref="ModelReading.Physical"/>.</summary>
        public static ModelOptions Physical => new ModelOptions { clampLift = true };

        /// <summary>The options of <see cref="ModelReading.Paper"/>.</summary>
        public static ModelOptions Paper => new ModelOptions
        {
            coefficients = CoefficientSet.Paper,
            tangent = AirTangent.BaseToTip,
            clampLift = true,
            cycleChange = CycleChange.Step,
            torqueArm = TorqueArm.OwnLoadAboutRoot,
            springUnits = SpringUnits.Printed,
            coupling = MembraneCoupling.OneWay,
            timeScheme = TimeScheme.BackwardEuler,
        };

        /// <summary>Problem of the first option that is none of its kind's, as one sentence; null where there is none.</summary>
        internal readonly string FindProblem() =>
            Undefined(nameof(coefficients), coefficients) ?? Undefined(nameof(tangent), tangent)
            ?? Undefined(nameof(cycleChange), cycleChange)
            ?? Undefined(nameof(torqueArm), torqueArm) ?? Undefined(nameof(springUnits), springUnits)
            ?? Undefined(nameof(coupling), coupling)
            ?? Undefined(nameof(timeScheme), timeScheme);

        /// <summary>These options, those of <see cref="ModelReading.Physical"/> in place of each that is none of its kind's.</summary>
        internal readonly ModelOptions Defined()
        {
            ModelOptions defined = this;
            defined.coefficients = OrFirst(coefficients);
            defined.tangent = OrFirst(tangent);
            defined.cycleChange = OrFirst(cycleChange);
            defined.torqueArm = OrFirst(torqueArm);
            defined.springUnits = OrFirst(springUnits);
            defined.coupling = OrFirst(coupling);
            defined.timeScheme = OrFirst(timeScheme);
            return defined;
        }

        private static string Undefined<T>(string name, T value) where T : unmanaged, Enum => Known<T>.Has(value)
            ? null
            : $"options.{name} is {value}; it must be one of {string.Join(", ", Known<T>.values)}.";

        private static T OrFirst<T>(T value) where T : unmanaged, Enum => Known<T>.Has(value) ? value : default;

        /// <summary>Returns true where every option is equal.</summary>
        public bool Equals(ModelOptions other) =>
            coefficients == other.coefficients && tangent == other.tangent && clampLift == other.clampLift
                && cycleChange == other.cycleChange && torqueArm == other.torqueArm && springUnits == other.springUnits
                && coupling == other.coupling && timeScheme == other.timeScheme && addedMass == other.addedMass
                && bodyReaction == other.bodyReaction && attachedRotation == other.attachedRotation;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is ModelOptions other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() =>
            HashCode.Combine(
                coefficients, tangent, clampLift, cycleChange, torqueArm, springUnits, coupling,
                HashCode.Combine(timeScheme, addedMass, bodyReaction, attachedRotation));

        // Looked up once: Enum.IsDefined boxes, and presets are compared in every step.
        private static class Known<T> where T : unmanaged, Enum
        {
            public static readonly T[] values = (T[])Enum.GetValues(typeof(T));

            public static bool Has(T value) => Array.IndexOf(values, value) >= 0;
        }
    }
}
