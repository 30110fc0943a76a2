using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Name, unit, bounds and default of one number of <see cref="WingParameters"/>, defined here alone.</summary>
    [MovedFrom(true, null, "Alate")]
    public sealed class WingParameterRange
    {
        /// <summary>The field of <see cref="WingParameters"/> that a range is about.</summary>
        public delegate ref float Field(ref WingParameters parameters);

        private const float k_QuarterTurn = 0.5f * math.PI, k_Turn = 2f * math.PI, k_Degree = math.PI / 180f;

        internal static readonly WingParameterRange[] s_All =
        {
            new WingParameterRange("maxFrequency", "hertz", 0.1f, 11f, 1000f, (ref WingParameters p) => ref p.maxFrequency),
            new WingParameterRange("maxSpeed", "metres per second", 0.01f, 2f, 100f, (ref WingParameters p) => ref p.maxSpeed),
            new WingParameterRange("frequencyFloor", "", 0f, 0.8f, 1f, (ref WingParameters p) => ref p.frequencyFloor),
            new WingParameterRange("amplitudeFloor", "", 0f, 0.5f, 1f, (ref WingParameters p) => ref p.amplitudeFloor),
            new WingParameterRange("amplitude.x", "radians", 0f, 60f * k_Degree, k_QuarterTurn, (ref WingParameters p) => ref p.amplitude.x),
            new WingParameterRange("amplitude.y", "radians", 0f, 18f * k_Degree, k_QuarterTurn, (ref WingParameters p) => ref p.amplitude.y),
            new WingParameterRange("amplitude.z", "radians", 0f, 12f * k_Degree, k_QuarterTurn, (ref WingParameters p) => ref p.amplitude.z),
            new WingParameterRange("phase.x", "radians", -k_Turn, 0f, k_Turn, (ref WingParameters p) => ref p.phase.x),
            new WingParameterRange("phase.y", "radians", -k_Turn, -k_QuarterTurn, k_Turn, (ref WingParameters p) => ref p.phase.y),
            new WingParameterRange("phase.z", "radians", -k_Turn, -k_QuarterTurn, k_Turn, (ref WingParameters p) => ref p.phase.z),
            new WingParameterRange("meanFlap", "radians", -k_QuarterTurn, 10f * k_Degree, k_QuarterTurn, (ref WingParameters p) => ref p.meanFlap),
            new WingParameterRange("tilt", "radians", -k_QuarterTurn, 0f, k_QuarterTurn, (ref WingParameters p) => ref p.tilt),
            new WingParameterRange("chordDelay", "half beats", 0f, 0.15f, 2f, (ref WingParameters p) => ref p.chordDelay),
            new WingParameterRange("spanDelay", "half beats", 0f, 0.1f, 2f, (ref WingParameters p) => ref p.spanDelay),
            new WingParameterRange("rootShare", "", 0f, 0.8f, 1f, (ref WingParameters p) => ref p.rootShare),
            new WingParameterRange("inertia", "", 0f, 1f, 10f, (ref WingParameters p) => ref p.inertia),
            new WingParameterRange("airDensity", "wing masses per cubed wing length", 0f, 11.1f, 1e5f, (ref WingParameters p) => ref p.airDensity),
            new WingParameterRange("strongestWind", "", 0.1f, 0.65f, 1000f, (ref WingParameters p) => ref p.strongestWind),
            new WingParameterRange("elasticity", "", 1e-3f, 1f, 1e6f, (ref WingParameters p) => ref p.elasticity),
            new WingParameterRange("referenceFrequency", "hertz", 0.01f, 12.08f, 1e5f, (ref WingParameters p) => ref p.referenceFrequency),
            new WingParameterRange("stiffnessRoot", "", 0.01f, 5f, 100f, (ref WingParameters p) => ref p.stiffnessRoot),
            new WingParameterRange("stiffnessTip", "", 0.01f, 3.5f, 100f, (ref WingParameters p) => ref p.stiffnessTip),
            new WingParameterRange("stiffnessDecay", "chain lengths", 0.05f, 1f, 100f, (ref WingParameters p) => ref p.stiffnessDecay),
            new WingParameterRange("bendDamping", "", 0f, 0.7f, 10f, (ref WingParameters p) => ref p.bendDamping),
            new WingParameterRange("dorsalAsymmetry", "", 0.1f, 1.4f, 10f, (ref WingParameters p) => ref p.dorsalAsymmetry),
            new WingParameterRange("inPlaneFactor", "", 0f, 25f, 1000f, (ref WingParameters p) => ref p.inPlaneFactor),
            new WingParameterRange("torsionFactor", "", 0f, 1f, 1000f, (ref WingParameters p) => ref p.torsionFactor),
            new WingParameterRange("jointLimit", "radians", 0f, 30f * k_Degree, k_QuarterTurn, (ref WingParameters p) => ref p.jointLimit),
            new WingParameterRange("springScale", "", 0f, 10f, 1000f, (ref WingParameters p) => ref p.springScale),
            new WingParameterRange("anchor", "", 0f, 2f, 100f, (ref WingParameters p) => ref p.anchor),
            new WingParameterRange("springDamping", "", 0f, 0.3f, 10f, (ref WingParameters p) => ref p.springDamping),
            new WingParameterRange("amplitudeScale", "", 0f, 1f, 2f, (ref WingParameters p) => ref p.amplitudeScale),
            new WingParameterRange("phaseLead", "radians", -k_Turn, 0f, k_Turn, (ref WingParameters p) => ref p.phaseLead),
        };

        private WingParameterRange(string name, string unit, float minimum, float preset, float maximum, Field field)
        {
            Name = name;
            Unit = unit;
            Minimum = minimum;
            Default = preset;
            Maximum = maximum;
            Of = field;
        }

        /// <summary>Every number of <see cref="WingParameters"/>, in the order of its fields (the substeps, a count, are kept there).</summary>
        public static IReadOnlyList<WingParameterRange> All => s_All;

        /// <summary>The name of the field, "amplitude.x" for a component.</summary>
        public string Name { get; }

        /// <summary>The unit in words, empty for a ratio.</summary>
        public string Unit { get; }

        /// <summary>The smallest allowed value.</summary>
        public float Minimum { get; }

        /// <summary>The value of a monarch's wing by <see cref="ModelReading.Physical"/>.</summary>
        public float Default { get; }

        /// <summary>The largest allowed value.</summary>
        public float Maximum { get; }

        /// <summary>Reads or writes the field in a set of parameters.</summary>
        public Field Of { get; }

        /// <summary>Returns true where the value is a number between the bounds.</summary>
        public bool Contains(float value) => value >= Minimum && value <= Maximum;

        /// <summary>The nearest value between the bounds; the default when the value is not a number.</summary>
        public float Clamp(float value) => float.IsNaN(value) ? Default : math.clamp(value, Minimum, Maximum);

        /// <summary>Describes in one line why the value is refused.</summary>
        public string Describe(float value)
        {
            var unit = Unit.Length == 0 ? "" : " " + Unit;
            return FormattableString.Invariant($"{Name} is {value}{unit}; it must be between {Minimum} and {Maximum}.");
        }
    }
}
