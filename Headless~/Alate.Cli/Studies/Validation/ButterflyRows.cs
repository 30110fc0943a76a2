using Alate.Flight;

namespace Alate.Cli;

/// <summary>Comparisons of the catalogue's monarch with measured butterflies, and of flexible with rigid wings.</summary>
internal static class ButterflyRows
{
    private const float k_Speed = 1.3f;

    /// <summary>Factor on the substeps of the bobbing trim, whose own are those of flights.</summary>
    private const int k_Finer = 2;

    private const string k_Record = "monarch, climbing trim with the body held still", k_Held = "monarch held at 1.3 m/s",
        k_Hsu = "Hsu et al. 2024, J. R. Soc. Interface 21, bluebottle flies", k_Kang = FreeRows.Kang;

    /// <summary>The monarch in the climb that was measured.</summary>
    public static IEnumerable<ValidationRow> Climbing(Fineness fineness, Action done)
    {
        const double k_Pitch = 18.6, k_Plane = 25.4;
        TrimState climb = FreeMonarch.Climb(fineness.Substeps, null, (Radians(k_Pitch), Radians(k_Plane)), out _);
        TrimState fine = FreeMonarch.Climb(
            fineness.Fine, climb, (Radians(k_Pitch), Radians(k_Plane)), out (double Up, double Ahead) force);
        (double bob, double fineBob) = FreeMonarch.ClimbingBobs(k_Finer, out double left);
        string reason = "one value, without a spread; with the beat of the trim, at the pitch and stroke plane of the animal, the wings "
            + Text($"would carry {force.Up:0.00} of the weight and push by {force.Ahead:0.00} of it. One that bobs by the forces of its ")
            + "beat has no converged trim here: its pitch bobs "
            + Text($"by ±{Degrees(bob):0}° at the substeps of flights and by ")
            + Text($"±{Degrees(fineBob):0}° at twice as many, where {100 * left:0} % of the weight is left");
        yield return Bare(k_Record, "mean pitch of the thorax, °", Text($"measured: {k_Pitch}"), k_Kang, Degrees(climb?.Pitch),
            Degrees(fine?.Pitch), reason);
        yield return Bare(k_Record, "stroke plane off the vertical, °", Text($"measured: {k_Plane}"), k_Kang,
            Degrees(climb?.Pitch + climb?.Tilt), Degrees(fine?.Pitch + fine?.Tilt),
            "one value, without a spread; the stroke plane is raised with the body");
        done();
    }

    /// <summary>The wings of a monarch that is held at 1.3 m/s, nose up by 30° as it flies, and level, at two finenesses of time.</summary>
    public static IEnumerable<ValidationRow> Held(Fineness fineness, Action done)
    {
        foreach (double pitch in new[] { 30.0, 0.0 })
        {
            string variant = pitch == 0 ? "level" : null;
            FlightRecord soft = Fly(false, fineness.Substeps, pitch), fine = Fly(false, fineness.Fine, pitch);
            FlightRecord stiff = Fly(true, fineness.Substeps, pitch), fineStiff = Fly(true, fineness.Fine, pitch);
            double push = Thrust(fine), stiffPush = Thrust(fineStiff);
            yield return new ValidationRow(k_Held, "thrust of rigid wings over that of flexible ones, %", 59, 98, "computed: 59 to 98",
                "the range of its flights", k_Hsu, 100 * Thrust(stiff) / Thrust(soft), 100 * stiffPush / push)
            {
                Variant = variant,
                Reason = pitch == 0 ? null : Text($"it says nothing here: the flexible wings push by {push:0.000} of the weight, next to ")
                    + Text($"nothing, the rigid ones by {stiffPush:0.000}"),
            };
            yield return new ValidationRow(k_Held, "largest twist of the upstroke over that of the downstroke", 1, double.PositiveInfinity,
                "measured: above 1", "one side of 1", "Wootton 1993, butterflies", Twists(soft), Twists(fine))
            {
                Variant = variant,
                Reason = pitch == 0 ? null : "the preset's dorsal asymmetry is chosen for it",
            };
            var camber = new ValidationRow(k_Held,
                "smaller of the mean cambers of both strokes, negative where their signs differ, % of the chord",
                double.NegativeInfinity, 0,
                "measured: the sign turns", "one side of 0", "Walker et al. 2009, locust", Cambers(soft), Cambers(fine))
            {
                Variant = variant,
            };
            yield return camber.IsInside || !camber.IsCounted ? camber
                : camber with { Experiments = [.. Changes(fineness.Substeps, pitch)] };
            done();
        }
    }

    private static IEnumerable<ValidationExperiment> Changes(int substeps, double pitch)
    {
        FlightPlan plan = Plan(false, substeps, pitch);
        yield return new ValidationExperiment("no deformation wave",
            Cambers(TetheredFlight.Fly(plan with { Column = ComparisonColumn.NoWave })));
        yield return new ValidationExperiment("half of the delay λ of the drive over the chord",
            Cambers(TetheredFlight.Fly(plan with { Lag = 0.5 * Lag() })));
        yield return new ValidationExperiment("a quarter of the elasticity", Cambers(TetheredFlight.Fly(plan with { Elasticity = 0.25 })));
        yield return new ValidationExperiment("level", Cambers(TetheredFlight.Fly(plan with { PitchDegrees = 0 })));
        yield return new ValidationExperiment("added mass", Cambers(TetheredFlight.Fly(plan with { AddedMass = true })));
    }

    private static double Lag()
    {
        WingPreset preset = InsectCatalogue.Find("monarch").Wings[0].CreatePreset();
        double lag = preset.ToParameters().chordDelay;
        UnityEngine.Object.DestroyImmediate(preset);
        return lag;
    }

    private static ValidationRow Bare(
        string record, string quantity, string published, string source, double ours, double fine, string reason) =>
        new(record, quantity, double.NegativeInfinity, double.PositiveInfinity, published, "", source, ours, fine) { Reason = reason };

    private static FlightRecord Fly(bool rigid, int substeps, double pitch) => TetheredFlight.Fly(Plan(rigid, substeps, pitch));

    private static FlightPlan Plan(bool rigid, int substeps, double pitch) => new()
    {
        Species = "monarch",
        Speed = k_Speed,
        PitchDegrees = pitch,
        Substeps = substeps,
        Column = rigid ? ComparisonColumn.RigidWing : ComparisonColumn.FullModel,
    };

    // Mean force of all wings along the way of the body, over the weight.
    internal static double Thrust(FlightRecord flight)
    {
        return flight.Plan.ToWorld(FlightSummary.Of(flight).MeanForce).z
            / (EarthGravity.Precise * flight.Wings[0].Wing.Preset.Size.insectMass);
    }

    internal static double Twists(FlightRecord flight) => Largest(flight, false) / Largest(flight, true);

    private static double Largest(FlightRecord flight, bool down) =>
        Half(flight, down).Max(frame => Math.Abs(flight.Wings[0].Measurement.Twist(frame.Positions)));

    // The product over its size, times the smaller of both: below 0 where the sign turns, and how far.
    internal static double Cambers(FlightRecord flight)
    {
        double down = Mean(flight, true), up = Mean(flight, false);
        return 100 * Math.Sign(down * up) * Math.Min(Math.Abs(down), Math.Abs(up));
    }

    private static double Mean(FlightRecord flight, bool down)
    {
        RecordedWing wing = flight.Wings[0];
        var camber = new BeatCurve(wing.Frames, wing.Frames.ConvertAll(frame => (double)wing.Measurement.Camber(frame.Positions)));
        return down ? camber.Mean(0, 0.5) : camber.Mean(0.5, 1);
    }

    internal static double Radians(double degrees) => Math.PI / 180 * degrees;

    internal static double Degrees(double? radians) => 180 / Math.PI * (radians ?? double.NaN);

    private static string Text(FormattableString text) =>
        text.ToString(System.Globalization.CultureInfo.InvariantCulture).Replace('-', '−');

    private static IEnumerable<RecordedFrame> Half(FlightRecord flight, bool down) =>
        flight.Wings[0].Frames.Where(frame => frame.Phase < Math.PI == down);
}
