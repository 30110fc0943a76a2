namespace Alate.Cli;

/// <summary>
/// Gusts over some beats: two that rise and fall smoothly in a beat each, then one that begins and ends at once and lasts one beat and a
/// half.
/// </summary>
internal static class GustProfile
{
    /// <summary>Beats from still air to still air.</summary>
    public const int Beats = 6;

    /// <summary>Beats before the first gust, in which the beat settles.</summary>
    public const double SmoothFrom = 1.5;

    private const double k_SmoothTo = 3.5, k_SharpFrom = 4.0, k_SharpTo = 5.5;

    /// <summary>Share of the wind's speed at a time.</summary>
    /// <param name="beats">Since the start.</param>
    public static double ShareAt(double beats)
    {
        if (beats >= SmoothFrom && beats < k_SmoothTo)
            return 0.5 - 0.5 * Math.Cos(2.0 * Math.PI * (beats - SmoothFrom));
        return beats >= k_SharpFrom && beats < k_SharpTo ? 1.0 : 0.0;
    }
}
