using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>
/// forces.csv: force and moment of the air after every step, newtons and newton metres. Lift is against gravity, drag against the flight;
/// the half stroke is that of the flap.
/// </summary>
internal static class ForceTable
{
    private static readonly string[] s_Header =
    [
        "time_s", "phase_deg", "half_stroke", "force_x_n", "force_y_n", "force_z_n", "moment_x_nm", "moment_y_nm", "moment_z_nm", "lift_n",
        "drag_n", "power_w",
    ];

    /// <summary>Rows of a flight on the spot, body axes about the middle of the thorax; a power is not measured there.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(FlightRecord flight)
    {
        yield return s_Header;
        float3 up = flight.Plan.UpOfBody;
        var along = new float3(0f, (float)flight.Plan.Climb, (float)flight.Plan.Speed);
        for (int k = 0; k < flight.Wings[0].Frames.Count; k++)
        {
            float3 force = default, moment = default;
            foreach (RecordedWing wing in flight.Wings)
            {
                PresetSize size = wing.Wing.Preset.Size;
                float unit = size.wingMass * size.wingLength;
                force += unit * wing.Placement.DirectionToBody(wing.Frames[k].AirForce);
                moment += unit * size.wingLength * wing.Placement.AxisToBody(wing.Frames[k].AirMoment);
            }

            RecordedFrame frame = flight.Wings[0].Frames[k];
            float3 way = math.normalizesafe(up * along.y + math.normalizesafe(math.cross(new float3(1f, 0f, 0f), up)) * along.z);
            yield return Row(frame.Time, frame.Phase, force, moment, math.dot(force, up), -math.dot(force, way), double.NaN);
        }
    }

    /// <summary>Rows of a free flight, forces along the world's axes, moments in body axes about the centre of mass.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(FreeRecord flight) => flight.Moments
        .Select(at => Row(
            at.Time, at.Phase, at.Force, at.Moment, at.Force.y, -math.dot(at.Force, math.normalizesafe(at.Velocity - at.Wind)), at.Power))
        .Prepend(s_Header);

    private static string[] Row(double time, double phase, float3 force, float3 moment, double lift, double drag, double power) =>
    [
        Number(time), Number(180.0 / Math.PI * phase), phase < Math.PI ? "down" : "up", Number(force.x), Number(force.y), Number(force.z),
        Number(moment.x), Number(moment.y), Number(moment.z), Number(lift), Number(drag), double.IsNaN(power) ? "" : Number(power),
    ];
}
