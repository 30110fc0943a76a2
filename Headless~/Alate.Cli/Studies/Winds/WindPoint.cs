namespace Alate.Cli;

/// <summary>Effect of a wind of one speed on a wing, from the worst side.</summary>
/// <param name="Speed">m/s, as this species meets it.</param>
/// <param name="StretchMaxPct">Largest stretch of an edge from any side, %.</param>
/// <param name="StretchP99Pct">99th percentile of the stretch over edges and times, from the side where that is largest, %.</param>
/// <param name="Worst">The side of <paramref name="StretchMaxPct"/>; null in still air.</param>
/// <param name="HeadBendDeg">Largest bend of the tip in a wind from ahead, degrees.</param>
/// <param name="Resets">How often a wing fell back to its driven pose.</param>
internal sealed record WindPoint(
    double Speed, double StretchMaxPct, double StretchP99Pct, WindDirection Worst, double HeadBendDeg, int Resets);
