using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>wake.csv: loads of each wing over the last beat with the wake, and the force without it, in axes of the body.</summary>
internal static class WakeTable
{
    private static readonly string[] s_Header =
    [
        "turn", "wing", "force_x_n", "force_y_n", "force_z_n", "moment_x_nm", "moment_y_nm", "moment_z_nm", "power_w",
        "still_force_x_n", "still_force_y_n", "still_force_z_n", "inflow_x_m_s", "inflow_y_m_s", "inflow_z_m_s",
    ];

    /// <summary>Rows: each wing at each step. Where the flight is symmetric the right wings alone.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(WakeRounds rounds)
    {
        yield return s_Header;
        List<RecordedWing> shed = rounds.Wake.Wings, flown = [.. rounds.Wake.Flight.Wings];
        RecordedWing[] still = [.. shed.Select(wing => rounds.Still.Wings[flown.IndexOf(wing)])];
        foreach (WakeMoment at in rounds.Beat)
        {
            for (int k = 0; k < at.Wings.Count; k++)
            {
                WakeLoad load = at.Wings[k];
                float3 without = FlownLoads.Force(still[k], at.Turns);
                yield return
                [
                    Number(at.Turns), shed[k].SideAndName, Number(load.Force.x), Number(load.Force.y), Number(load.Force.z),
                    Number(load.Moment.x), Number(load.Moment.y), Number(load.Moment.z), Number(load.Power),
                    Number(without.x), Number(without.y), Number(without.z),
                    Number(load.Inflow.x), Number(load.Inflow.y), Number(load.Inflow.z),
                ];
            }
        }
    }

    /// <summary>Rows for the terminal: means of all wings over the weight, with the wake and without; a row a round of several.</summary>
    public static IEnumerable<IReadOnlyList<string>> Summary(WakeRounds rounds)
    {
        WakeRound still = rounds.All[0], last = rounds.All[^1];
        yield return ["", "with the wake", "without"];
        yield return ["lift / weight", Share(last.Wake.y), Share(still.Replayed.y)];
        yield return ["thrust / weight", Share(last.Wake.z), Share(still.Replayed.z)];
        yield return ["power to the air, W/kg", Share(last.Power), Share(still.ReplayedPower)];
    }

    /// <summary>Rows for the terminal: what came of each round.</summary>
    public static IEnumerable<IReadOnlyList<string>> Convergence(WakeRounds rounds)
    {
        yield return
        [
            "round", "lift / weight", "replayed", "thrust / weight", "replayed", "power, W/kg", "replayed", "change of the air, %",
        ];
        for (int k = 0; k < rounds.All.Count; k++)
        {
            WakeRound round = rounds.All[k];
            yield return
            [
                $"{k + 1}", Exact(round.Wake.y), Exact(round.Replayed.y), Exact(round.Wake.z), Exact(round.Replayed.z), Share(round.Power),
                Share(round.ReplayedPower), (100 * round.Change).ToString("0.0", CultureInfo.InvariantCulture),
            ];
        }
    }

    private static string Exact(double value) => value.ToString("0.0000", CultureInfo.InvariantCulture).Replace('-', '−');

    private static string Share(double value) => value.ToString("0.00", CultureInfo.InvariantCulture).Replace('-', '−');
}
