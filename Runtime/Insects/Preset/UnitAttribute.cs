using System;

namespace Alate
{
    /// <summary>Unit of a preset's number, and its bounds where it has no slider. The command line shows them; a test compares the manual's table.</summary>
    [AttributeUsage(AttributeTargets.Field)]
    internal sealed class UnitAttribute : Attribute
    {
        /// <param name="unit">As in the manual, empty for a ratio.</param>
        public UnitAttribute(string unit)
        {
            Unit = unit;
        }

        public UnitAttribute(string unit, float min, float max)
            : this(unit)
        {
            Min = min;
            Max = max;
        }

        public string Unit { get; }

        public float Min { get; }

        public float Max { get; }
    }
}
