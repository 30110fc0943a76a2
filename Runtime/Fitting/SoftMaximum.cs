using System;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Place of a function's largest value as a weighted mean over the places around it: on a flat top its middle, where the plain maximum
    /// would jump about with the least change of the outline. Other tops, beyond a valley, do not count.
    /// </summary>
    internal static class SoftMaximum
    {
        /// <summary>Natural logarithm of the smallest weight, which parts a top from others.</summary>
        private const double k_Valley = 5.0;

        /// <summary>Mean place, weighted by exp(sharpness · value).</summary>
        /// <param name="from">First place.</param>
        /// <param name="to">Last place.</param>
        /// <param name="steps">Even steps between them, at least 1.</param>
        /// <param name="sharpness">Weight falls to 1/e where the value is 1/sharpness less.</param>
        /// <param name="value">Of a place; −∞ excludes it.</param>
        /// <param name="spread">Standard deviation of the places about their mean: how unclear the maximum is.</param>
        public static double Find(double from, double to, int steps, double sharpness, Func<double, double> value, out double spread)
        {
            double[] values = new double[steps + 1];
            int top = 0;
            for (int k = 0; k <= steps; k++)
            {
                values[k] = value(from + (to - from) * k / steps);
                top = values[k] > values[top] ? k : top;
            }

            double least = values[top] - k_Valley / sharpness, sum = 0.0, first = 0.0, second = 0.0;
            int end = EndOfTop(values, top, 1, least);
            for (int k = EndOfTop(values, top, -1, least); k <= end; k++)
            {
                double weight = Elementary.Exp(sharpness * (values[k] - values[top])), share = (double)k / steps;
                sum += weight;
                first += weight * share;
                second += weight * share * share;
            }

            double mean = first / sum;
            spread = Math.Abs(to - from) * Math.Sqrt(Math.Max(second / sum - mean * mean, 0.0));
            return from + (to - from) * mean;
        }

        // The last one that way before a valley.
        private static int EndOfTop(double[] values, int top, int step, double least)
        {
            int k = top;
            while (k + step >= 0 && k + step < values.Length && values[k + step] >= least)
                k += step;
            return k;
        }
    }
}
