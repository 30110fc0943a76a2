namespace Alate.Cli;

/// <summary>
/// Chord of a fly's wing over its span: a beta distribution whose radius of the second moment is 0.58 of the length, as that of the wing of
/// Dickinson, Lehmann and Sane 1999 and of Weis-Fogh's fruit fly.
/// </summary>
internal static class FlyPlanform
{
    /// <summary>Squared radius of the second moment over the squared length.</summary>
    public const double Moment = 0.58 * 0.58;

    private const double k_Inner = 1.628, k_Outer = 1.473;

    private static readonly double s_Mean = Enumerable.Range(0, 2000).Average(k => Beta((k + 0.5) / 2000.0));

    /// <summary>Chord at a share of the span, in the unit of the mean one.</summary>
    /// <param name="share">From the root, 0, to the tip, 1.</param>
    /// <param name="mean">Mean chord.</param>
    public static double Chord(double share, double mean) => mean * Beta(share) / s_Mean;

    private static double Beta(double share) => Math.Pow(share, k_Inner - 1.0) * Math.Pow(Math.Max(1.0 - share, 1e-9), k_Outer - 1.0);
}
