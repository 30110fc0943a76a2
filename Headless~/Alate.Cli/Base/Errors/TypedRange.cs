namespace Alate.Cli;

/// <summary>
/// Checks a number that a user typed where the model takes something that is made of it, such as its product with a species' own number.
/// </summary>
internal static class TypedRange
{
    private const int k_Halvings = 100, k_Digits = 6;

    /// <summary>Refuses a number out of its range, with the option's name and the range of what may be typed.</summary>
    /// <param name="option">The name of the option.</param>
    /// <param name="value">What was typed.</param>
    /// <param name="min">The least that the option takes.</param>
    /// <param name="max">The most that the option takes.</param>
    /// <param name="subject">What it is typed for: the insect, the parameter.</param>
    /// <param name="own">A number that holds.</param>
    /// <param name="holds">Whether what is made of a number is in its own range.</param>
    /// <exception cref="UserException">The number is out of its range.</exception>
    public static void Check(string option, double value, double min, double max, string subject, double own, Func<double, bool> holds)
    {
        if (value >= min && value <= max && holds(value))
            return;
        throw new UserException(
            $"{option} must lie between {Text(Bound(own, min, holds))} and "
            + $"{Text(Bound(own, max, holds))} for {subject}; it is {Text(value)}.");
    }

    // The number nearest to the limit that holds, in few digits.
    private static double Bound(double own, double limit, Func<double, bool> holds)
    {
        if (holds(limit))
            return limit;
        double inside = own, outside = limit;
        for (int k = 0; k < k_Halvings; k++)
        {
            double middle = inside * outside > 0 ? Math.Sign(inside) * Math.Sqrt(inside * outside) : 0.5 * (inside + outside);
            if (holds(middle))
                inside = middle;
            else
                outside = middle;
        }

        return Rounded(inside, outside < inside);
    }

    // Plain digits where they are few.
    private static string Text(double value) =>
        value.ToString(value == 0 || Math.Abs(value) is >= 1e-4 and < 1e9 ? "0.##########" : "G6", CultureInfo.InvariantCulture);

    // Towards the numbers that hold.
    private static double Rounded(double value, bool up)
    {
        if (value == 0)
            return 0;
        double unit = Math.Pow(10, Math.Floor(Math.Log10(Math.Abs(value))) + 1 - k_Digits), units = value / unit;
        double near = Math.Round(units);
        return (Math.Abs(units - near) < 1e-3 ? near : up ? Math.Ceiling(units) : Math.Floor(units)) * unit;
    }
}
