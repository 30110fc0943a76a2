namespace Alate.Cli;

/// <summary>Shares of a measure's variance that a parameter makes, after Sobol.</summary>
/// <param name="First">Alone: the first-order index.</param>
/// <param name="Total">With all others: the total index.</param>
internal readonly record struct Sensitivity(double First, double Total)
{
    /// <summary>
    /// The indices of each parameter: the first order by Saltelli et al. 2010, the total by Jansen 1999, both as the former's table 2 has
    /// them, about the mean, which makes fewer points do.
    /// </summary>
    /// <param name="values">Of the runs of <see cref="StudyDesign.SaltelliPoints"/>, in its order.</param>
    /// <param name="parameters">Number of parameters.</param>
    /// <returns>NaN where a run has no value, or all have the same.</returns>
    public static Sensitivity[] Of(IReadOnlyList<double> values, int parameters)
    {
        int count = values.Count / (parameters + 2);
        double mean = values.Take(2 * count).Average(), variance = values.Take(2 * count).Average(value => (value - mean) * (value - mean));
        var found = new Sensitivity[parameters];
        for (int k = 0; k < parameters; k++)
        {
            double first = 0, total = 0;
            for (int run = 0; run < count; run++)
            {
                double a = values[run], b = values[count + run], mixed = values[(2 + k) * count + run];
                first += (b - mean) * (mixed - a);
                total += 0.5 * (a - mixed) * (a - mixed);
            }

            found[k] = new Sensitivity(first / count / variance, total / count / variance);
        }

        return found;
    }
}
