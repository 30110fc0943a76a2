namespace Alate.Cli;

/// <summary>Largest stretch of an edge that a wing may have up to some wind.</summary>
/// <param name="Speed">m/s.</param>
/// <param name="StretchPct">%.</param>
internal sealed record WindLimit(double Speed, double StretchPct)
{
    /// <summary>The limits of a variant, from weak wind to strong.</summary>
    public static IReadOnlyList<WindLimit> Of(InsectVariant variant) => variant == InsectVariant.Expressive
        ? [new(3, 15), new(5, 20), new(10, 28)]
        : [new(3, 10), new(5, 12), new(10, 15)];
}
