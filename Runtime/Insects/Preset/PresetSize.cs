using System;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Size and mass of an insect, and the density of the fluid around it. Biological sizes: the size of the mesh in the scene does not
    /// matter.
    /// </summary>
    [Serializable]
    [MovedFrom(true, null, null, "SpeciesSize")]
    public struct PresetSize
    {
        /// <summary>Wing length L, metres, 0.0005 to 1.</summary>
        [Unit("m", WingBounds.WingLength.Min, WingBounds.WingLength.Max)]
        [Tooltip("Metres from hinge to tip of one wing of the real insect, 0.0005 to 1; a monarch's is 0.061. Longer wings feel more air "
            + "and more gravity for their beat.")]
        public float wingLength;

        /// <summary>m_w, kilograms, 10⁻⁹ to 1: one wing as it is simulated, a fore and hind wing couple when they move as one.</summary>
        [Unit("kg", WingBounds.WingMass.Min, WingBounds.WingMass.Max)]
        [Tooltip("Kilograms of one wing (of a fore and hind wing together when they move as one), 1e-9 to 1; a monarch's couple is "
            + "2.51e-5. Light wings are bent by air, heavy ones by their inertia.")]
        public float wingMass;

        /// <summary>
        /// Mass of the whole insect, kilograms, 10⁻⁸ to 10: its weight is compared with lift, and a flight carries it (that of the first
        /// wing counts). Trims go with it. Does not change how the wing bends.
        /// </summary>
        [Unit("kg", WingBounds.InsectMass.Min, WingBounds.InsectMass.Max)]
        [Tooltip("Kilograms of the whole insect, 1e-8 to 10; a monarch is 4.28e-4. Its weight is compared with lift, and Insect Flight "
            + "carries it: bake new trims after a change. The wing bends the same.")]
        public float insectMass;

        /// <summary>Density ρ of the fluid, kilograms per cubic metre, 0 to 2000; air 1.225, fresh water 998.</summary>
        [Range(WingBounds.FluidDensity.Min, WingBounds.FluidDensity.Max), Unit("kg/m³")]
        [Tooltip("Kilograms per cubic metre of what the wing beats in; air 1.225, water 998. 0 is a vacuum: the wing bends by "
            + "its inertia alone.")]
        public float fluidDensity;

        /// <summary>Share of gravity that the wing feels, 0 to 1: 1 in air, near 0 for a fin that floats in water.</summary>
        [Range(WingBounds.GravityShare.Min, WingBounds.GravityShare.Max), Unit("")]
        [Tooltip("Share of gravity the wing feels; 1 in air. 0 is a fin that neither sinks nor rises.")]
        public float gravityShare;

        /// <summary>Relative density ρ* = ρL³/m_w, without unit.</summary>
        public float RelativeDensity => fluidDensity * wingLength * wingLength * wingLength / wingMass;

        /// <summary>Unit of measured stiffness, 1/(m_w L³), kg⁻¹ m⁻³; see <see cref="WingParameters.stiffnessUnit"/>.</summary>
        internal readonly float StiffnessUnit => 1f / (wingMass * wingLength * wingLength * wingLength);

        /// <summary>A monarch's.</summary>
        internal static PresetSize Default => new PresetSize
        {
            wingLength = WingBounds.WingLength.Default,
            wingMass = WingBounds.WingMass.Default,
            insectMass = WingBounds.InsectMass.Default,
            fluidDensity = WingBounds.FluidDensity.Default,
            gravityShare = WingBounds.GravityShare.Default,
        };

        /// <summary>Sizes with lengths, masses and shares moved into their ranges.</summary>
        internal readonly PresetSize Clamped() => new PresetSize
        {
            wingLength = math.clamp(wingLength, WingBounds.WingLength.Min, WingBounds.WingLength.Max),
            wingMass = math.clamp(wingMass, WingBounds.WingMass.Min, WingBounds.WingMass.Max),
            insectMass = math.clamp(insectMass, WingBounds.InsectMass.Min, WingBounds.InsectMass.Max),
            fluidDensity = fluidDensity,
            gravityShare = math.clamp(gravityShare, WingBounds.GravityShare.Min, WingBounds.GravityShare.Max),
        };
    }
}
