using System;
using System.Collections.Generic;

namespace Alate.Samples
{
    /// <summary>
    /// The two-tailed one-sample t-test of the paper's user study (Sec. 7.2): whether the mean of a sample differs from an expected one.
    /// </summary>
    internal readonly struct OneSampleTTest
    {
        /// <param name="sample">Two values or more.</param>
        /// <param name="expected">The mean that chance would give.</param>
        /// <exception cref="ArgumentException">The sample has fewer than two values.</exception>
        public OneSampleTTest(IReadOnlyList<double> sample, double expected)
        {
            if (sample.Count < 2)
                throw new ArgumentException($"A t-test needs 2 values or more, not {sample.Count}.", nameof(sample));
            double sum = 0, squares = 0;
            foreach (double value in sample)
                sum += value;
            Mean = sum / sample.Count;
            foreach (double value in sample)
                squares += (value - Mean) * (value - Mean);
            DegreesOfFreedom = sample.Count - 1;
            double error = Math.Sqrt(squares / DegreesOfFreedom / sample.Count);
            double difference = Mean - expected;

            // Where all are alike and not as expected, there is no doubt left.
            T = difference == 0 ? 0 : difference / error;
            P = StudentT.TwoTailed(T, DegreesOfFreedom);
        }

        /// <summary>Mean of the sample.</summary>
        public double Mean { get; }

        /// <summary>Values less one.</summary>
        public int DegreesOfFreedom { get; }

        /// <summary>The difference from the expected mean over its standard error; ± infinity where all values are alike.</summary>
        public double T { get; }

        /// <summary>Probability of a difference at least this large by chance, 0 to 1.</summary>
        public double P { get; }
    }
}
