using static Alate.Formats.CsvTable;

namespace Alate.Cli;

/// <summary>
/// forces.csv: force and moment of the air and powers after every step, newtons, newton metres and watts. Lift is against gravity, drag
/// against the flight; the half stroke is that of the flap; powers are those of all wings, then of each.
/// </summary>
internal static class ForceTable
{
    private static readonly string[] s_Header =
    [
        "time_s", "phase_deg", "half_stroke", "force_x_n", "force_y_n", "force_z_n", "moment_x_nm", "moment_y_nm", "moment_z_nm", "lift_n",
        "drag_n", "power_w", "inertial_power_w", "positive_power_w", "negative_power_w",
    ];

    /// <summary>Rows of a flight on the spot, body axes about the middle of the thorax.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(FlightRecord flight)
    {
        yield return Header(flight.Wings.Select(wing => wing.SideAndName));
        float3 up = flight.Plan.UpOfBody, way = flight.Plan.WayOfBody;
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
            WingPower[] powers = [.. flight.Wings.Select(wing => wing.Frames[k].Power)];
            yield return Row(frame.Time, frame.Phase, force, moment, math.dot(force, up), -math.dot(force, way), powers);
        }
    }

    /// <summary>Rows of a free flight, forces along the world's axes, moments in body axes about the centre of mass.</summary>
    public static IEnumerable<IReadOnlyList<string>> Of(FreeRecord flight) => flight.Moments
        .Zip(flight.Powers, (at, powers) => Row(
            at.Time, at.Phase, at.Force, at.Moment, at.Force.y, -math.dot(at.Force, math.normalizesafe(at.Velocity - at.Wind)),
            powers))
        .Prepend(Header(flight.WingNames));

    private static string[] Header(IEnumerable<string> wings) =>
    [
        .. s_Header,
        .. wings.Select(wing => wing.Replace(' ', '_')).SelectMany(wing => new[]
        {
            $"{wing}_power_w", $"{wing}_inertial_power_w", $"{wing}_positive_power_w", $"{wing}_negative_power_w",
        }),
    ];

    private static string[] Row(
        double time, double phase, float3 force, float3 moment, double lift, double drag, IReadOnlyList<WingPower> powers) =>
    [
        Number(time), Number(180.0 / Math.PI * phase), phase < Math.PI ? "down" : "up", Number(force.x), Number(force.y), Number(force.z),
        Number(moment.x), Number(moment.y), Number(moment.z), Number(lift), Number(drag),
        .. Powers(powers.Aggregate(default(WingPower), (sum, one) => sum + one)), .. powers.SelectMany(Powers),
    ];

    private static string[] Powers(WingPower power) =>
        [Number(power.Air), Number(power.Inertial), Number(power.Positive), Number(power.Negative)];
}
