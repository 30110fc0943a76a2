namespace Alate.Cli;

/// <summary>wake.csv: force and power of each wing over the last beat, with the wake and without, in axes of the body.</summary>
internal static class WakeTable
{
    private static readonly string[] s_Header =
    [
        "turn", "wing", "force_x_n", "force_y_n", "force_z_n", "power_w", "still_force_x_n", "still_force_y_n", "still_force_z_n",
        "inflow_x_m_s", "inflow_y_m_s", "inflow_z_m_s",
    ];

    /// <summary>Rows: each wing at each step. Where the flight is symmetric the right wings alone.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(WakeFlight flight, IReadOnlyList<WakeMoment> beat)
    {
        yield return s_Header;
        foreach (WakeMoment at in beat)
        {
            for (int k = 0; k < at.Wings.Count; k++)
            {
                WakeLoad load = at.Wings[k];
                float3 still = StillLoads.Force(flight.Wings[k], at.Turns);
                yield return
                [
                    Number(at.Turns), NameOf(flight.Wings[k]), Number(load.Force.x), Number(load.Force.y), Number(load.Force.z),
                    Number(load.Power), Number(still.x), Number(still.y), Number(still.z), Number(load.Inflow.x), Number(load.Inflow.y),
                    Number(load.Inflow.z),
                ];
            }
        }
    }

    /// <summary>Rows for the terminal: means of all wings over the weight, with the wake and without.</summary>
    public static IEnumerable<IReadOnlyList<string>> Summary(WakeFlight flight, IReadOnlyList<WakeMoment> beat)
    {
        FlightPlan plan = flight.Flight.Plan;
        PresetSize size = flight.Flight.Wings[0].Wing.Preset.Size;
        double weight = size.insectMass * EarthGravity.Precise;
        float3 force = plan.ToWorld(beat.Aggregate(default(float3), (sum, at) => sum + at.Force) / beat.Count);
        float3 still = plan.ToWorld(StillLoads.Mean(flight.Flight));
        yield return ["", "with the wake", "without"];
        yield return ["lift / weight", Share(force.y / weight), Share(still.y / weight)];
        yield return ["thrust / weight", Share(force.z / weight), Share(still.z / weight)];
        yield return ["power to the air, W/kg", Share(beat.Average(at => at.Power) / size.insectMass),
            Share(StillLoads.Power(flight.Flight) / size.insectMass)];
    }

    /// <summary>Name of a wing: its kind and its side.</summary>
    public static string NameOf(RecordedWing wing) => $"{(wing.Placement.IsLeft ? "left" : "right")} {wing.Wing.Name}";

    private static string Number(double value) => value.ToString("0.######E+0", CultureInfo.InvariantCulture);

    private static string Share(double value) => value.ToString("0.00", CultureInfo.InvariantCulture).Replace('-', '−');
}
