using System;

namespace Alate
{
    /// <summary>
    /// The place of a function's largest value as a weighted mean over places: on a flat top its middle, where the plain maximum would
    /// jump about with the least change of the outline.
    /// </summary>
    internal static class SoftMaximum
    {
        /// <summary>The mean place, weighted by exp(sharpness · value).</summary>
        /// <param name="from">First place.</param>
        /// <param name="to">Last place.</param>
        /// <param name="steps">Even steps between them, at least 1.</param>
        /// <param name="sharpness">Weight falls to 1/e where the value is 1/sharpness less.</param>
        /// <param name="value">Of a place; −∞ excludes it.</param>
        /// <param name="spread">Standard deviation of the places about their mean: how unclear the maximum is.</param>
        public static double Find(double from, double to, int steps, double sharpness, Func<double, double> value, out double spread)
        {
            var values = new double[steps + 1];
            double largest = double.NegativeInfinity;
            for (int k = 0; k <= steps; k++)
            {
                values[k] = value(from + (to - from) * k / steps);
                largest = Math.Max(largest, values[k]);
            }

            double sum = 0.0, first = 0.0, second = 0.0;
            for (int k = 0; k <= steps; k++)
            {
                double weight = Math.Exp(sharpness * (values[k] - largest)), share = (double)k / steps;
                sum += weight;
                first += weight * share;
                second += weight * share * share;
            }

            double mean = first / sum;
            spread = Math.Abs(to - from) * Math.Sqrt(Math.Max(second / sum - mean * mean, 0.0));
            return from + (to - from) * mean;
        }
    }
}
