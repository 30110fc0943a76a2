namespace Alate.Cli;

/// <summary>free-flight.csv: each insect on the spot by the full model, as the paper has it, and in free flight by its own wings.</summary>
internal static class FreeComparisonTable
{
    public const string File = "free-flight.csv";

    private static readonly string[] s_Header =
    [
        "species", "flight", "variant", "speed_m_s", "climb_m_s", "velocity_error_m_s", "frequency_hz", "flap_deg", "pitch_deg",
        "pitch_bob_deg", "height_bob_mm",
        "lift_over_weight", "downstroke_lift_over_weight", "upstroke_support_share", "upstroke_force_share", "power_w",
        "power_per_mass_w_kg",
    ];

    public static void Write(IReadOnlyList<Comparison> comparisons, Stream stream) =>
        CsvTable.Write(stream, comparisons.SelectMany(Rows).Prepend(s_Header));

    /// <summary>Measures of both flights for the terminal; none where the insect does not fly.</summary>
    public static IEnumerable<IReadOnlyList<string>> Lines(Comparison comparison)
    {
        string[][] rows = Rows(comparison).ToArray();
        yield return ["", "on the spot", "free flight"];
        for (int k = 2; k < s_Header.Length && rows.Length > 1; k++)
            yield return [s_Header[k], rows[0][k], rows[1][k]];
    }

    private static IEnumerable<string[]> Rows(Comparison comparison)
    {
        FlightSummary held = comparison.Held.Summary;
        FlightPlan plan = comparison.Plan;
        RecordedWing wing = held.Flight.Wings[0];
        const double none = double.NaN;
        yield return
        [
            plan.Species, "on the spot", plan.Variant.ToString().ToLowerInvariant(),
            .. Numbers(plan.Speed, plan.Climb, none, wing.Frequency, none, plan.PitchDegrees, 0, 0, held.LiftOverWeight, none, none,
                none, none, none),
        ];
        if (comparison.Free is { } free)
        {
            yield return
            [
                plan.Species, "free", "flight",
                .. Numbers(
                    free.Speed, free.Climb, free.Error, free.Frequency, free.Flap, free.Pitch, free.PitchBob, free.HeightBob, free.Lift,
                    free.DownLift, free.UpSupport, free.UpForce,
                    free.Power, free.PowerPerMass),
            ];
        }
    }

    private static IEnumerable<string> Numbers(params double[] values) =>
        values.Select(value => double.IsNaN(value) ? "" : value.ToString("0.#####", CultureInfo.InvariantCulture));
}
