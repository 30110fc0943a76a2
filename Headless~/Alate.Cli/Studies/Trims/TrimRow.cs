namespace Alate.Cli;

/// <summary>
/// One trim: speed and climb m/s, angles in degrees, power to the air in mW, residuals over weight and weight times wing length.
/// </summary>
internal sealed record TrimRow(
    double Speed, double Climb, bool Closes, double Pitch, double PitchBob, double Frequency, double Flap, double Amplitude,
    double Tilt, double Sweep,
    double Power, double Lift, double Thrust, double Moment, string Problem)
{
    public static readonly string[] Header =
    [
        "speed_m_s", "climb_m_s", "closes", "pitch_deg", "pitch_bob_deg", "frequency_hz", "flap_deg", "amplitude", "tilt_deg",
        "mean_sweep_deg",
        "power_mw", "lift_residual", "thrust_residual", "moment_residual", "problem",
    ];

    /// <summary>The row as a table has it.</summary>
    public string[] Cells() =>
    [
        Number(Speed, "0.###"), Number(Climb, "0.###"), Closes ? "yes" : "no",
        .. new[] { Pitch, PitchBob, Frequency, Flap, Amplitude, Tilt, Sweep, Power }.Select(value => Number(value, "0.###")),
        .. new[] { Lift, Thrust, Moment }.Select(value => Number(value, "0.#####")), Problem ?? "",
    ];

    private static string Number(double value, string format) =>
        double.IsNaN(value) ? "" : value.ToString(format, CultureInfo.InvariantCulture);
}
