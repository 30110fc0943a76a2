using System;
using Alate.Geometry;

namespace Alate
{
    /// <summary>Values that a chain has from root to tip: one, or several that are spread evenly over its joints.</summary>
    internal static class ChainValues
    {
        /// <summary>Bounds of a flexural or torsional stiffness, N·m²: from below a thrips' wing to above a ruler of steel.</summary>
        public const float LeastStiffness = 1e-15f, MostStiffness = 1000f;

        /// <summary>Largest width of a vein, any unit.</summary>
        public const float MostWidth = 1e6f;

        /// <summary>Returns true where there are values.</summary>
        public static bool AreGiven(float[] values) => values != null && values.Length > 0;

        /// <summary>Value at a place of the chain, geometric between two values.</summary>
        /// <param name="values">At least one, all above 0.</param>
        /// <param name="place">0 at the root, 1 at the tip.</param>
        public static double At(float[] values, double place)
        {
            (float before, float after, double share) = Around(values, place);
            return before * Elementary.Pow((double)after / before, share);
        }

        /// <summary>Value at a place of the chain, linear between two values.</summary>
        /// <inheritdoc cref="At"/>
        public static double Between(float[] values, double place)
        {
            (float before, float after, double share) = Around(values, place);
            return before + (after - before) * share;
        }

        private static (float before, float after, double share) Around(float[] values, double place)
        {
            double at = place * (values.Length - 1);
            int before = Math.Min((int)at, Math.Max(values.Length - 2, 0));
            return (values[before], values[Math.Min(before + 1, values.Length - 1)], at - before);
        }

        /// <summary>Describes the first value that is not allowed, without the chain and a full stop; null when all are.</summary>
        /// <param name="name">Name of the values.</param>
        /// <param name="unit">Their unit, with a space before it, or empty.</param>
        /// <param name="values">May be null.</param>
        /// <param name="least">The smallest allowed value.</param>
        /// <param name="most">The largest allowed value.</param>
        public static string FindProblem(string name, string unit, float[] values, float least, float most)
        {
            if (!AreGiven(values))
                return null;
            if (values.Length > WingSkeleton.MaxJoints)
                return $"has {values.Length} values of {name}; it takes at most {WingSkeleton.MaxJoints}";
            for (int k = 0; k < values.Length; k++)
            {
                if (!(values[k] >= least && values[k] <= most))
                {
                    return FormattableString.Invariant(
                        $"has a {name} of {values[k]}{unit} (value {k}); it must be between {least} and {most}");
                }
            }

            return null;
        }
    }
}
