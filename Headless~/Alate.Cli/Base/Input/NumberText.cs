namespace Alate.Cli;

/// <summary>Numbers that a user types.</summary>
internal static class NumberText
{
    /// <summary>The numbers of a text with commas; NaN for what is none.</summary>
    public static double[] WithCommas(string text) => [.. text.Split(',').Select(part =>
        double.TryParse(part, NumberStyles.Float, CultureInfo.InvariantCulture, out double number) ? number : double.NaN)];
}
