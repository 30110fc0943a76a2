using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Resistance of the wing to bending, and the springs that hold its joints together (Sec. 6).</summary>
    [Serializable]
    [MovedFrom(true, null, null, "SpeciesStiffness")]
    public struct PresetStiffness
    {
        /// <summary>Elasticity k_e of Table 2, without unit, 0.001 to 10⁶.</summary>
        [Unit("", WingBounds.Elasticity.Min, WingBounds.Elasticity.Max)]
        [Tooltip("Elasticity as in the paper's Table 2, 0.001 to 1000000; 1 for a monarch, 0.5 for a soft fishfly. A quarter makes a rag, "
            + "four a stiff sheet.")]
        public float elasticity;

        /// <summary>Bending frequency N_0 of the leading chain over f_ref, 0.01 to 100.</summary>
        [Range(WingBounds.LeadingEdge.Min, WingBounds.LeadingEdge.Max), Unit("beats")]
        [Tooltip("How many times faster than the beat the leading edge would swing by itself; 5. Low lets the leading edge bend.")]
        public float leadingEdge;

        /// <summary>Bending frequency N_last of the last chain over f_ref, 0.01 to 100.</summary>
        [Range(WingBounds.TrailingEdge.Min, WingBounds.TrailingEdge.Max), Unit("beats")]
        [Tooltip("The same at the trailing edge; 3.5. Low lets the trailing edge trail and flutter.")]
        public float trailingEdge;

        /// <summary>Fall of the stiffness along a chain, chain lengths, 0.05 to 100.</summary>
        [Range(WingBounds.Decay.Min, WingBounds.Decay.Max), Unit("chain lengths")]
        [Tooltip("Way along a chain over which the stiffness falls to a third (1/e), in chain lengths; 1. Small values soften the tip, "
            + "large ones make all equal.")]
        public float decay;

        /// <summary>Damping ζ of a bending joint over its critical damping, 0 to 10.</summary>
        [Range(WingBounds.Damping.Min, WingBounds.Damping.Max), Unit("")]
        [Tooltip("Damping of the bending; 0.7. 0 rings for long; above 1 creeps back.")]
        public float damping;

        /// <summary>Stiffness against bending up over bending down, 0.1 to 10.</summary>
        [Range(WingBounds.DorsalAsymmetry.Min, WingBounds.DorsalAsymmetry.Max), Unit("")]
        [Tooltip("How much stiffer the wing is against bending upwards than downwards; 1.4. Above 1 it yields on the upstroke, below 1 on "
            + "the downstroke.")]
        public float dorsalAsymmetry;

        /// <summary>Stiffness in the wing's plane over that out of it, 0 to 1000.</summary>
        [Range(WingBounds.InPlaneFactor.Min, WingBounds.InPlaneFactor.Max), Unit("")]
        [Tooltip("How much stiffer the wing is in its plane than out of it; 25. Low values let it fold like a fan.")]
        public float inPlaneFactor;

        /// <summary>Stiffness in torsion over that in bending, 0 to 1000.</summary>
        [Range(WingBounds.TorsionFactor.Min, WingBounds.TorsionFactor.Max), Unit("")]
        [Tooltip("How much stiffer a chain is in torsion than in bending; 1.")]
        public float torsionFactor;

        /// <summary>Largest angle of a joint about each axis, degrees, 0 to 90.</summary>
        [Range(WingBounds.JointLimit.Min, WingBounds.JointLimit.Max), Unit("°")]
        [Tooltip("Degrees a joint may bend about each axis; 30. 0 is a rigid wing.")]
        public float jointLimit;

        /// <summary>Stiffness κ of the springs between joints, without unit, 0 to 1000.</summary>
        [Range(WingBounds.SpringScale.Min, WingBounds.SpringScale.Max), Unit("")]
        [Tooltip("Stiffness of the springs between the joints; 10. Low values let the surface stretch.")]
        public float springScale;

        /// <summary>Rate of the anchor over f_ref, 0 to 100.</summary>
        [Range(WingBounds.Anchor.Min, WingBounds.Anchor.Max), Unit("")]
        [Tooltip("How firmly the springs' joints follow the bent chains; 2. 0 lets them drift.")]
        public float anchor;

        /// <summary>Damping ζ_E of the elastic deviation, without unit, 0 to 10.</summary>
        [Range(WingBounds.SpringDamping.Min, WingBounds.SpringDamping.Max), Unit("")]
        [Tooltip("Damping of the springs; 0.3. 0 shivers; above 1 is sluggish.")]
        public float springDamping;

        /// <summary>
        /// Wind beyond which the wing hardly bends more, over v_ref = 2π f_ref · half the flap · L, 0.1 to 1000; see
        /// <see cref="WingParameters.strongestWind"/>.
        /// </summary>
        [Range(WingBounds.StrongestWind.Min, WingBounds.StrongestWind.Max), Unit("")]
        [Tooltip("Wind beyond which the wing hardly bends more, over the speed of a wing tip at top speed; 0.65, 3.2 m/s for a monarch. "
            + "1000 takes every wind as it is.")]
        public float strongestWind;

        /// <summary>A monarch's.</summary>
        internal static PresetStiffness Default => new PresetStiffness
        {
            elasticity = WingBounds.Elasticity.Default,
            leadingEdge = WingBounds.LeadingEdge.Default,
            trailingEdge = WingBounds.TrailingEdge.Default,
            decay = WingBounds.Decay.Default,
            damping = WingBounds.Damping.Default,
            dorsalAsymmetry = WingBounds.DorsalAsymmetry.Default,
            inPlaneFactor = WingBounds.InPlaneFactor.Default,
            torsionFactor = WingBounds.TorsionFactor.Default,
            jointLimit = WingBounds.JointLimit.Default,
            springScale = WingBounds.SpringScale.Default,
            anchor = WingBounds.Anchor.Default,
            springDamping = WingBounds.SpringDamping.Default,
            strongestWind = WingBounds.StrongestWind.Default,
        };

        /// <summary>
        /// Stiffness with the numbers without a slider moved into their ranges, and the strongest wind that version 0.1 did not save.
        /// </summary>
        internal readonly PresetStiffness Clamped()
        {
            PresetStiffness clamped = this;
            clamped.elasticity = math.clamp(elasticity, WingBounds.Elasticity.Min, WingBounds.Elasticity.Max);
            if (strongestWind <= 0f)
                clamped.strongestWind = WingBounds.StrongestWind.Default;
            return clamped;
        }

        /// <summary>Writes the stiffness in the units of the model.</summary>
        internal readonly void WriteTo(ref WingParameters parameters)
        {
            parameters.elasticity = elasticity;
            parameters.stiffnessRoot = leadingEdge;
            parameters.stiffnessTip = trailingEdge;
            parameters.stiffnessDecay = decay;
            parameters.bendDamping = damping;
            parameters.dorsalAsymmetry = dorsalAsymmetry;
            parameters.inPlaneFactor = inPlaneFactor;
            parameters.torsionFactor = torsionFactor;
            parameters.jointLimit = math.radians(jointLimit);
            parameters.springScale = springScale;
            parameters.anchor = anchor;
            parameters.springDamping = springDamping;
            parameters.strongestWind = strongestWind > 0f ? strongestWind : WingBounds.StrongestWind.Default;
        }
    }
}
