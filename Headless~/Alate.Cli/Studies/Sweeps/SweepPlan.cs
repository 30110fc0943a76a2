namespace Alate.Cli;

/// <summary>Parameter to sweep, its values, and the choice of flights with the deformation wave, without it, or both.</summary>
internal sealed class SweepPlan
{
    public const int MinSteps = 2, MaxSteps = 25, DefaultSteps = 5;

    /// <summary>Values that span this factor or more are spaced by equal ratios.</summary>
    private const double k_Wide = 10;

    /// <summary>Plans a sweep between two values.</summary>
    /// <exception cref="UserException">The values are the same.</exception>
    public SweepPlan(FlownParameter parameter, double from, double to, int steps, FlightPlan flight, SweepWaves waves)
    {
        Parameter = parameter;
        Flight = flight;
        Waves = waves;
        IsLogarithmic = from > 0 && to > 0 && Math.Max(from / to, to / from) >= k_Wide;
        var values = new List<double>();
        for (int k = 0; k < steps; k++)
        {
            double share = (double)k / (steps - 1);
            double value = IsLogarithmic ? from * Math.Pow(to / from, share) : from + (to - from) * share;
            value = parameter.IsWhole ? Math.Round(value) : Rounded(value);
            if (values.Count == 0 || value != values[^1])
                values.Add(value);
        }

        if (values.Count < 2)
            throw new UserException($"FROM and TO of {parameter.Name} must differ.");
        Values = values;
    }

    public FlownParameter Parameter { get; }

    /// <summary>In the order of the sweep, FROM first.</summary>
    public IReadOnlyList<double> Values { get; }

    /// <summary>True where the values are spaced by equal ratios.</summary>
    public bool IsLogarithmic { get; }

    public FlightPlan Flight { get; }

    public SweepWaves Waves { get; }

    // Six digits: so that a table says 0.5, not 0.5000000001.
    private static double Rounded(double value) => value == 0 ? 0 : double.Parse(
        value.ToString("G6", System.Globalization.CultureInfo.InvariantCulture), System.Globalization.CultureInfo.InvariantCulture);
}
