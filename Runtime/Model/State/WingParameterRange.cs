using System;
using System.Collections.Generic;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Name, unit, bounds and default of one number of <see cref="WingParameters"/>.</summary>
    [MovedFrom(true, null, "Alate")]
    public sealed class WingParameterRange
    {
        /// <summary>The field of <see cref="WingParameters"/> that a range is about.</summary>
        public delegate ref float Field(ref WingParameters parameters);

        internal WingParameterRange(string name, string unit, float minimum, float preset, float maximum, Field field)
        {
            Name = name;
            Unit = unit;
            Minimum = minimum;
            Default = preset;
            Maximum = maximum;
            Of = field;
        }

        /// <summary>Range of an angle that is given in degrees.</summary>
        internal static WingParameterRange Angle(string name, float minimum, float preset, float maximum, Field field)
        {
            const double degree = Math.PI / 180.0;
            return new WingParameterRange(
                name, "radians", (float)(minimum * degree), (float)(preset * degree), (float)(maximum * degree), field);
        }

        /// <summary>
        /// Every number of <see cref="WingParameters"/>, in the order of its fields (the substeps, a count, are kept there).
        /// </summary>
        public static IReadOnlyList<WingParameterRange> All => WingParameters.s_Ranges;

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
        public float Clamp(float value) => NumberRange.Clamp(value, Minimum, Maximum, Default);

        /// <summary>Describes in one line why the value is refused.</summary>
        public string Describe(float value)
        {
            string unit = Unit.Length == 0 ? "" : " " + Unit;
            return FormattableString.Invariant($"{Name} is {value}{unit}; it must be between {Minimum} and {Maximum}.");
        }
    }
}
