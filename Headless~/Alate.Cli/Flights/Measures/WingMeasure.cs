namespace Alate.Cli;

/// <summary>One of the numbers of a wing's beat: what files and tables call it, and where to read it.</summary>
/// <param name="Key">Its name in files, with the unit.</param>
/// <param name="Title">Its name to show, with the unit.</param>
/// <param name="Of">Reads it.</param>
internal sealed record WingMeasure(string Key, string Title, Func<WingSummary, double> Of)
{
    /// <summary>All measures in the order of the files.</summary>
    public static IReadOnlyList<WingMeasure> All { get; } =
    [
        new("frequency_hz", "frequency, Hz", wing => wing.FrequencyHz),
        new("twist_pp_deg", "twist, peak to peak, °", wing => wing.TwistPpDeg),
        new("camber_min_pct", "camber, least, % of the chord", wing => wing.CamberMinPct),
        new("camber_max_pct", "camber, most, % of the chord", wing => wing.CamberMaxPct),
        new("tip_bend_pp_deg", "tip bend, peak to peak, °", wing => wing.TipBendPpDeg),
        new("tip_bend_max_deg", "tip bend, largest, °", wing => wing.TipBendMaxDeg),
        new("lag_deg", "lag of the trailing edge, °", wing => wing.LagDeg),
        new("tip_lag_deg", "lag of the tip, °", wing => wing.TipLagDeg),
        new("edge_stretch_max_pct", "edge stretch, largest, %", wing => wing.EdgeStretchMaxPct),
        new("edge_stretch_p99_pct", "edge stretch, 99th percentile, %", wing => wing.EdgeStretchP99Pct),
    ];
}
