namespace Alate.Cli;

/// <summary>trajectory.csv: the centre of mass, its velocity, the attitude and the beat after every step.</summary>
internal static class TrajectoryTable
{
    private static readonly string[] s_Header =
    [
        "time_s", "x_m", "y_m", "z_m", "vx_m_s", "vy_m_s", "vz_m_s", "wanted_vx_m_s", "wanted_vy_m_s", "wanted_vz_m_s",
        "commanded_vx_m_s", "commanded_vy_m_s", "commanded_vz_m_s", "commanded_heading_deg", "heading_deg", "pitch_deg", "roll_deg",
        "wx_rad_s", "wy_rad_s", "wz_rad_s", "phase_deg", "frequency_hz", "half_flap_deg", "aid_w", "state",
    ];

    public static IEnumerable<IReadOnlyList<string>> Of(FreeRecord flight) => flight.Moments.Select(Row).Prepend(s_Header);

    private static string[] Row(FreeMoment at)
    {
        float3 ahead = math.rotate(at.Rotation, new float3(0f, 0f, 1f)), right = math.rotate(at.Rotation, new float3(1f, 0f, 0f));
        double[] numbers =
        [
            at.Time, at.Position.x, at.Position.y, at.Position.z, at.Velocity.x, at.Velocity.y, at.Velocity.z, at.Wanted.x,
            at.Wanted.y, at.Wanted.z, at.Commanded.x, at.Commanded.y, at.Commanded.z, Degrees(at.CommandedHeading),
            Degrees(Math.Atan2(ahead.x, ahead.z)), Degrees(Math.Asin(Math.Clamp(ahead.y, -1f, 1f))),
            Degrees(-Math.Asin(Math.Clamp(right.y, -1f, 1f))),
            at.AngularVelocity.x, at.AngularVelocity.y, at.AngularVelocity.z, Degrees(at.Phase), at.Frequency,
            Degrees(at.Amplitude), at.AidPower,
        ];
        return [.. numbers.Select(Text), at.State.ToString()];
    }

    // Nothing where no heading is asked for.
    private static string Text(double number) => double.IsNaN(number) ? "" : number.ToString("0.######", CultureInfo.InvariantCulture);

    private static double Degrees(double radians) => 180.0 / Math.PI * radians;
}
