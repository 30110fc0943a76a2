namespace Alate.Drawing;

/// <summary>One axis of a chart: from where to where, and which values have a line and a label.</summary>
/// <param name="From">Value of its beginning.</param>
/// <param name="To">Value of its end, above the beginning.</param>
/// <param name="IsLogarithmic">Equal ratios are equally far apart.</param>
/// <param name="Ticks">Labelled values.</param>
internal sealed record ChartAxis(double From, double To, bool IsLogarithmic, IReadOnlyList<double> Ticks)
{
    private static readonly double[] s_Steps = [1.0, 2.0, 5.0], s_Rough = [1.0, 2.0, 2.5, 5.0, 10.0];

    /// <summary>An axis with ticks at 1, 2 and 5 times powers of ten that holds two values and all between them.</summary>
    /// <param name="least">Above 0.</param>
    /// <param name="most">At least as much.</param>
    public static ChartAxis Logarithmic(double least, double most)
    {
        var ticks = new List<double>();
        for (int power = (int)Math.Floor(Math.Log10(least)); power <= Math.Ceiling(Math.Log10(most)); power++)
        {
            foreach (double step in s_Steps)
                ticks.Add(step * Math.Pow(10.0, power));
        }

        const double k_Slack = 1e-9;
        int first = ticks.FindLastIndex(tick => tick <= least * (1.0 + k_Slack)),
            last = ticks.FindIndex(tick => tick >= most * (1.0 - k_Slack));
        last = Math.Max(last, first + 1);
        return new ChartAxis(ticks[first], ticks[last], true, ticks.GetRange(first, last - first + 1));
    }

    /// <summary>An axis with round ticks that holds all values that are finite, and nought.</summary>
    public static ChartAxis Linear(IEnumerable<double> values) => Around(values.Append(0.0));

    /// <summary>An axis with round ticks that holds all values that are finite.</summary>
    public static ChartAxis Around(IEnumerable<double> values)
    {
        double low = double.PositiveInfinity, high = double.NegativeInfinity;
        foreach (double value in values.Where(double.IsFinite))
            (low, high) = (Math.Min(low, value), Math.Max(high, value));
        if (low > high)
            (low, high) = (0.0, 1.0);
        if (high - low < 1e-6)
            high = low + Math.Max(1.0, 1e-3 * Math.Abs(low));
        double rough = (high - low) / 4.0, unit = Math.Pow(10.0, Math.Floor(Math.Log10(rough)));
        double step = unit * s_Rough.First(factor => factor * unit >= rough * 0.999);
        var ticks = new List<double>();
        for (double k = Math.Floor(low / step + 1e-9); k <= Math.Ceiling(high / step - 1e-9); k++)
            ticks.Add(k * step);
        return new ChartAxis(ticks[0], ticks[^1], false, ticks);
    }

    /// <summary>Place of a value along the axis: 0 its beginning, 1 its end.</summary>
    public float Fraction(double value) => (float)((Scaled(value) - Scaled(From)) / (Scaled(To) - Scaled(From)));

    private double Scaled(double value) => IsLogarithmic ? Math.Log(value) : value;
}
