using System;

namespace Alate
{
    /// <summary>
    /// Unit of a preset's number, and its bounds where it has no slider. The command line shows them; a test compares the manual's table.
    /// </summary>
    [AttributeUsage(AttributeTargets.Field)]
    internal sealed class UnitAttribute : Attribute
    {
        /// <param name="unit">As in the manual, empty for a ratio.</param>
        /// <param name="min">Least value, where there is no slider.</param>
        /// <param name="max">Largest value, where there is no slider.</param>
        public UnitAttribute(string unit, float min = 0f, float max = 0f)
        {
            Unit = unit;
            Min = min;
            Max = max;
        }

        public string Unit { get; }

        public float Min { get; }

        public float Max { get; }
    }
}
