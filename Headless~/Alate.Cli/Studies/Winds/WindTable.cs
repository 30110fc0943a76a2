namespace Alate.Cli;

/// <summary>wind.csv: one row for each kind of wing, model and speed; and the tables of the terminal.</summary>
internal static class WindTable
{
    public static void Write(IReadOnlyList<SpeciesWinds> species, bool inGusts, Stream stream) =>
        CsvTable.Write(stream, Rows(species, inGusts));

    /// <summary>A wing over all speeds.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(WingWinds wing)
    {
        yield return ["wind, m/s", "stretch, largest, %", "99th percentile, %", "worst from", "tip bend, head wind, °", "0.1: largest, %",
            "0.1: 99th, %"];
        for (int k = 0; k < wing.Now.Count; k++)
        {
            WindPoint now = wing.Now[k], before = wing.Before[k];
            yield return
            [
                Number(now.Speed, 2), Number(now.StretchMaxPct, 1), Number(now.StretchP99Pct, 1), now.Worst?.Name ?? "",
                Number(now.HeadBendDeg, 1),
                Number(before.StretchMaxPct, 1), Number(before.StretchP99Pct, 1),
            ];
        }
    }

    private static IEnumerable<IReadOnlyList<string>> Rows(IReadOnlyList<SpeciesWinds> species, bool inGusts)
    {
        yield return
        [
            "species", "variant", "wing", "model", "air", "wind_m_s", "edge_stretch_max_pct", "edge_stretch_p99_pct", "worst_from",
            "head_wind_tip_bend_max_deg", "resets",
        ];
        foreach (SpeciesWinds one in species)
        {
            foreach (WingWinds wing in one.Wings)
            {
                foreach (WindPoint point in wing.Now)
                    yield return Row(one, wing, "now", inGusts, point);
                foreach (WindPoint point in wing.Before)
                    yield return Row(one, wing, "0.1", inGusts, point);
            }
        }
    }

    private static string[] Row(SpeciesWinds species, WingWinds wing, string model, bool inGusts, WindPoint point) =>
    [
        species.Plan.Species, species.Plan.Variant.ToString().ToLowerInvariant(), wing.Name, model, inGusts ? "gusts" : "steady",
        Plain(point.Speed),
        Plain(point.StretchMaxPct), Plain(point.StretchP99Pct), point.Worst?.Name ?? "", Plain(point.HeadBendDeg),
        point.Resets.ToString(CultureInfo.InvariantCulture),
    ];

    private static string Plain(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);

    private static string Number(double value, int digits) => value.ToString(digits == 1 ? "0.0" : "0.##", CultureInfo.InvariantCulture);
}
