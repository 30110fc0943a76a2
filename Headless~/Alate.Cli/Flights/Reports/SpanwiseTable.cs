using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>
/// spanwise.csv: air on strips along the span of each wing after every substep of the last beat. Sums over the strips of all wings are
/// forces and moments of forces.csv.
/// </summary>
internal static class SpanwiseTable
{
    private static readonly string[] s_Header =
    [
        "time_s", "phase_deg", "wing", "side", "span_m", "area_m2", "lift_n", "drag_n", "force_x_n", "force_y_n", "force_z_n",
        "moment_x_nm", "moment_y_nm", "moment_z_nm", "pitching_nm", "attack_deg",
    ];

    /// <summary>Rows of a flight on the spot that records its air.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(FlightRecord flight) => flight.Wings
        .SelectMany(wing => wing.Frames.SelectMany(frame => frame.Strips.Select((strip, k) => Row(flight.Plan, wing, frame, strip, k))))
        .Prepend(s_Header);

    private static string[] Row(FlightPlan plan, RecordedWing wing, RecordedFrame frame, in SpanStrip strip, int k)
    {
        PresetSize size = wing.Wing.Preset.Size;
        float unit = size.wingMass * size.wingLength;
        float3 force = unit * wing.Placement.DirectionToBody(strip.Force);
        float3 moment = unit * size.wingLength * wing.Placement.AxisToBody(strip.Moment);
        return
        [
            Number(frame.Time), Number(180.0 / Math.PI * frame.Phase), wing.Wing.Name, wing.Placement.IsLeft ? "left" : "right",
            Number((k + 0.5) / SpanStrip.Count * size.wingLength), Number(strip.Area * size.wingLength * size.wingLength),
            Number(math.dot(force, plan.UpOfBody)), Number(-math.dot(force, plan.WayOfBody)),
            Number(force.x), Number(force.y), Number(force.z), Number(moment.x), Number(moment.y), Number(moment.z),
            Number(unit * size.wingLength * strip.Pitching),
            double.IsNaN(strip.Attack) ? "" : Number(180.0 / Math.PI * strip.Attack),
        ];
    }
}
