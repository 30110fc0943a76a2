using System;
using System.Diagnostics;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Checks of a job's fields before it is scheduled, where Unity's safety checks are on; elsewhere their calls are left out. They
    /// allocate nothing that passes.
    /// </summary>
    internal static class JobFields
    {
        /// <summary>Symbol with which Unity compiles where its safety checks are on.</summary>
        public const string Checks = "ENABLE_UNITY_COLLECTIONS_CHECKS";

        /// <summary>Checks the length of an array.</summary>
        /// <exception cref="ArgumentException">It is shorter than that.</exception>
        [Conditional(Checks)]
        public static void AtLeast(long length, long least, string field)
        {
            if (length < least)
                throw new ArgumentException($"{field} has room for {length}; the job needs {least}.");
        }

        /// <summary>Checks an index or a count.</summary>
        /// <exception cref="ArgumentException">It is not from the first to the last.</exception>
        [Conditional(Checks)]
        public static void InRange(long value, long first, long last, string field)
        {
            if (value < first || value > last)
                throw new ArgumentException($"{field} is {value}; it must be from {first} to {last}.");
        }

        /// <summary>Checks a number that must be finite, and 0 or more.</summary>
        /// <exception cref="ArgumentException">It is not.</exception>
        [Conditional(Checks)]
        public static void NotNegative(float value, string field)
        {
            if (!(value >= 0f && math.isfinite(value)))
                throw new ArgumentException(FormattableString.Invariant($"{field} is {value}; it must be finite, and 0 or more."));
        }

        /// <summary>Checks a number that must be finite.</summary>
        /// <exception cref="ArgumentException">It is not.</exception>
        [Conditional(Checks)]
        public static void Finite(float value, string field)
        {
            if (!math.isfinite(value))
                throw new ArgumentException(FormattableString.Invariant($"{field} is {value}; it must be finite."));
        }

        /// <summary>Checks the steps of all clocks.</summary>
        /// <exception cref="ArgumentException">A length is not finite or below 0, a count below 0, or the time that is drawn not within the
        /// step.</exception>
        [Conditional(Checks)]
        public static void Steps(ClockTimes clocks)
        {
            for (int k = 0; k < ClockTimes.Count; k++)
            {
                ClockTime clock = clocks[k];
                NotNegative(clock.length, "The length of a step");
                InRange(clock.count, 0, int.MaxValue, "The number of steps");
                InRange(clock.substeps, 0, int.MaxValue, "The number of substeps");
                if (!(clock.alpha >= 0f && clock.alpha <= 1f))
                {
                    throw new ArgumentException(
                        FormattableString.Invariant($"The time within a step that is drawn is {clock.alpha}; it must be from 0 to 1."));
                }
            }
        }
    }
}
