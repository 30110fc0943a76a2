namespace Alate.Cli;

/// <summary>sweep.csv: one row for each value, kind of wing, and with or without the wave.</summary>
internal static class SweepTable
{
    public static void Write(Sweep sweep, Stream stream) => CsvTable.Write(stream, Rows(sweep));

    private static IEnumerable<IReadOnlyList<string>> Rows(Sweep sweep)
    {
        string parameter = sweep.Plan.Parameter.Name.Replace('-', '_');
        yield return [parameter, "wave", "wing", .. WingMeasure.All.Select(measure => measure.Key), "camber_load_pp_pct",
            "lift_over_weight", "resets"];
        foreach (SweepPoint point in sweep.Points)
        {
            for (int k = 0; k < point.Summary.Wings.Count; k++)
            {
                WingSummary wing = point.Summary.Wings[k];
                yield return
                [
                    point.Value.ToString("G9", CultureInfo.InvariantCulture), point.HasWave ? "on" : "off", wing.Name,
                    .. WingMeasure.All.Select(measure => Number(measure.Of(wing))), Number(point.LoadCamberPct[k]),
                    Number(point.Summary.LiftOverWeight), point.Summary.Resets.ToString(CultureInfo.InvariantCulture),
                ];
            }
        }
    }

    private static string Number(double value) => value.ToString("0.####", CultureInfo.InvariantCulture);
}
