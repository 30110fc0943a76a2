using Alate.Flight;

namespace Alate.Cli;

/// <summary>Comparisons of the catalogue's monarch with measured butterflies, and of flexible with rigid wings.</summary>
internal static class ButterflyRows
{
    private const float k_Speed = 1.3f;

    /// <summary>Factor on the substeps of the bobbing trim, whose own are those of flights.</summary>
    private const int k_Finer = 2;

    private const string k_Halves = "Bode-Oke and Dong 2020, a monarch in forward flight", k_Dudley = "Dudley 1991, butterflies",
        k_Hsu = "Hsu et al. 2024, a blowfly";
    private const string k_Kang = "Kang, Sridhar et al. 2020, a monarch that climbs by 0.75 m/s at 1.28 m/s",
        k_Feathering = "another insect was measured; a monarch's thrust comes from the feathering that its wings take from air and inertia",
        k_Attitude = "the model's monarch flies at another pitch and stroke plane";

    /// <summary>The monarch carried by its own wings.</summary>
    public static IEnumerable<ValidationRow> Free(Fineness fineness, Action done)
    {
        FreeMonarch ours = FreeMonarch.Fly(fineness.Substeps), fine = FreeMonarch.Fly(fineness.Fine);
        done();
        string pitching = Text(
            $"the model's monarch bobs by ±{fine.PitchBob:0.0}° of pitch, the measured one by ±8.3°, and its upstroke pulls it down");
        yield return new ValidationRow("monarch, free flight: upstroke's share of the force, %", 27, 37, "32; ± 5 is our tolerance",
            k_Halves, ours.UpForce, fine.UpForce, pitching);
        yield return new ValidationRow("monarch, free flight: upstroke's share of the weight support, %", 3, 13, "8; ± 5 is our tolerance",
            k_Halves, ours.UpSupport, fine.UpSupport, pitching);
        yield return new ValidationRow("monarch, free flight: power to the air, W/kg", 12.5, 20.2, "12.5 to 20.2", k_Dudley, ours.Power,
            fine.Power, "other species than a monarch were measured");
        yield return new ValidationRow("monarch, free flight: mean angle of attack in the middle of the downstroke, °", 29, 49,
            "39; ± 10 is our tolerance", k_Dudley, ours.DownAttack, fine.DownAttack, k_Attitude);
        yield return new ValidationRow("monarch, free flight: mean angle of attack in the middle of the upstroke, °", 12, 32,
            "22; ± 10 is our tolerance", k_Dudley, ours.UpAttack, fine.UpAttack, k_Attitude);
        yield return new ValidationRow("monarch, free flight: bob of the pitch, half of its range, °", 5.3, 11.3,
            "8.3; ± 3 is our tolerance", k_Kang, ours.PitchBob, fine.PitchBob, "level flight, not a climb; the abdomen is rigid");
        done();
    }

    /// <summary>The monarch in the climb that was measured.</summary>
    public static IEnumerable<ValidationRow> Climbing(Fineness fineness, Action done)
    {
        const double k_Pitch = 18.6, k_Plane = 25.4;
        TrimState climb = FreeMonarch.Climb(fineness.Substeps, null, (Radians(k_Pitch), Radians(k_Plane)), out _);
        TrimState fine = FreeMonarch.Climb(
            fineness.Fine, climb, (Radians(k_Pitch), Radians(k_Plane)), out (double Up, double Ahead) force);
        (double bob, double fineBob) = FreeMonarch.ClimbingBobs(k_Finer, out double left);
        string cause = "with the beat of the trim, at the pitch and stroke plane of the animal, the wings would carry "
            + Text($"{force.Up:0.00} of the weight and push by {force.Ahead:0.00} of it: the model has no other means to turn its force ")
            + "up. The trim holds the body still; one that bobs by the forces of its beat has no converged trim here: its pitch bobs "
            + Text($"by ±{Degrees(bob):0}° at the substeps of flights and by ")
            + Text($"±{Degrees(fineBob):0}° at twice as many, where {100 * left:0} % of the weight is left");
        yield return new ValidationRow("monarch, climbing trim with the body held still: mean pitch of the thorax, °", k_Pitch - 5,
            k_Pitch + 5, "18.6; ± 5 is our tolerance", k_Kang, Degrees(climb?.Pitch), Degrees(fine?.Pitch), cause);
        yield return new ValidationRow(
            "monarch, climbing trim with the body held still: stroke plane off the vertical, °", k_Plane - 5, k_Plane + 5,
            "25.4; ± 5 is our tolerance", k_Kang,
            Degrees(climb?.Pitch + climb?.Tilt), Degrees(fine?.Pitch + fine?.Tilt),
            "as with the pitch: the stroke plane is raised with the body");
        done();
    }

    /// <summary>The wings of a monarch that is held at 1.3 m/s, level and nose up by 30°, at two finenesses of time.</summary>
    public static IEnumerable<ValidationRow> Held(Fineness fineness, Action done)
    {
        foreach (double pitch in new[] { 0.0, 30.0 })
        {
            FlightRecord soft = Fly(false, fineness.Substeps, pitch), fine = Fly(false, fineness.Fine, pitch);
            FlightRecord stiff = Fly(true, fineness.Substeps, pitch), fineStiff = Fly(true, fineness.Fine, pitch);
            string held = pitch == 0 ? "monarch held level at 1.3 m/s" : "monarch held at 1.3 m/s, nose up by 30°";
            double push = Thrust(fine), stiffPush = Thrust(fineStiff), ratio = 100 * stiffPush / push;
            yield return pitch == 0
                ? new ValidationRow(
                    $"{held}: thrust of rigid wings over that of flexible ones, %", 59, 98, "59 to 98", k_Hsu,
                    100 * Thrust(stiff) / Thrust(soft), ratio, k_Feathering)
                : new ValidationRow(
                    $"{held}: thrust of rigid wings less that of flexible ones, over the weight", double.NegativeInfinity, 0,
                    Text($"59 to 98 %, which is below 0. The ratio here is {ratio:0} % and says nothing: the flexible wings push by ")
                    + Text($"{push:0.000} of the weight, next to nothing, the rigid ones by {stiffPush:0.000}"),
                    k_Hsu, Thrust(stiff) - Thrust(soft), stiffPush - push, k_Feathering);
            yield return new ValidationRow(
                $"{held}: largest twist of the upstroke over that of the downstroke", 1, double.PositiveInfinity, "above 1",
                "Wootton 1993, butterflies",
                Twists(soft), Twists(fine),
                "the delayed drive twists both strokes alike; only the dorsal asymmetry of the joints tells them apart");
            yield return new ValidationRow(
                $"{held}: smaller of the mean cambers of both strokes, negative where their signs differ, % of the chord",
                double.NegativeInfinity, 0, "the sign turns", "Walker et al. 2009, locust",
                Cambers(soft), Cambers(fine), "the delayed drive cambers the wing most at the turns of the stroke, by either sign; what is "
                    + "left over a half stroke is small and of one sign");
            done();
        }
    }

    private static FlightRecord Fly(bool rigid, int substeps, double pitch) => TetheredFlight.Fly(new FlightPlan
    {
        Species = "monarch",
        Speed = k_Speed,
        PitchDegrees = pitch,
        Substeps = substeps,
        Column = rigid ? ComparisonColumn.RigidWing : ComparisonColumn.FullModel,
    });

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
