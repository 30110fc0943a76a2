using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Figures;
using Alate.Cli.Flights;
using Alate.Cli.FreeFlights;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Cli.Validation;

/// <summary>Comparisons of the catalogue's monarch with measured butterflies, and of flexible with rigid wings.</summary>
internal static class ButterflyRows
{
    private const float k_Speed = 1.3f;
    private const int k_Beats = 60;
    private const string k_Halves = "Bode-Oke and Dong 2020, a monarch in forward flight", k_Dudley = "Dudley 1991, butterflies";
    private const string k_Pitching = "the model's monarch pitches more than the measured one, ±9° at this speed, and its upstroke pulls it down";
    private const string k_Kang = "Kang, Sridhar et al. 2020, a monarch that climbs by 0.75 m/s at 1.28 m/s", k_Raised = "the model carries the insect by raising body and stroke plane further than the animal does";

    /// <summary>The monarch carried by its own wings, level at 1.3 m/s.</summary>
    public static IEnumerable<ValidationRow> Free(Action done)
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using FlightModel model = CatalogueFlight.CreateModel(monarch);
        using TrimTable table = CatalogueFlight.CreateTable(monarch, model);
        var level = SteadyFlight.Fly(model, table, new FlightCondition(k_Speed, 0f));
        done();
        yield return new ValidationRow("monarch, free flight: upstroke's share of the force, %", 27, 37, "32; ± 5 is our tolerance", k_Halves, 100 * level.UpForce, double.NaN, k_Pitching);
        yield return new ValidationRow("monarch, free flight: upstroke's share of the weight support, %", 3, 13, "8; ± 5 is our tolerance", k_Halves, 100 * level.UpSupport, double.NaN, k_Pitching);
        yield return new ValidationRow("monarch, free flight: power to the air, W/kg", 12.5, 20.2, "12.5 to 20.2", k_Dudley, level.PowerPerMass, double.NaN, "other species than a monarch were measured");
        (double down, double up) = Attacks(model, table);
        yield return new ValidationRow("monarch, free flight: mean angle of attack in the middle of the downstroke, °", 29, 49, "39; ± 10 is our tolerance", k_Dudley, down, double.NaN, "the model's monarch flies at another pitch and stroke plane");
        yield return new ValidationRow("monarch, free flight: mean angle of attack in the middle of the upstroke, °", 12, 32, "22; ± 10 is our tolerance", k_Dudley, up, double.NaN, "the model's monarch flies at another pitch and stroke plane");
        TrimState climbing = FlightFigures.MeasuredClimb(model, out _);
        done();
        if (climbing == null)
            yield break;
        yield return new ValidationRow("monarch, climbing trim: mean pitch of the thorax, °", 13.6, 23.6, "18.6; ± 5 is our tolerance", k_Kang, math.degrees((double)climbing.Pitch), double.NaN, k_Raised);
        yield return new ValidationRow("monarch, climbing trim: stroke plane off the vertical, °", 20.4, 30.4, "25.4; ± 5 is our tolerance", k_Kang, math.degrees((double)climbing.Pitch + climbing.Tilt), double.NaN, k_Raised);
    }

    /// <summary>The wings of a monarch that is held at 1.3 m/s, level and nose up by 30°, at two finenesses of time.</summary>
    public static IEnumerable<ValidationRow> Held(Action done)
    {
        yield return new ValidationRow(
            "monarch held level at 1.3 m/s: thrust of rigid wings over that of flexible ones, %", 59, 98, "59 to 98", "Hsu et al. 2024, a blowfly",
            Thrusts(DragonflyRows.Substeps), Thrusts(DragonflyRows.FineSubsteps), "another insect was measured; a monarch's thrust comes from the feathering that its wings take from air and inertia");
        foreach (double pitch in new[] { 0.0, 30.0 })
        {
            FlightRecord soft = Fly(false, DragonflyRows.Substeps, pitch), fine = Fly(false, DragonflyRows.FineSubsteps, pitch);
            string held = pitch == 0 ? "monarch held level at 1.3 m/s" : "monarch held at 1.3 m/s, nose up by 30°";
            yield return new ValidationRow(
                $"{held}: largest twist of the upstroke over that of the downstroke", 1, double.PositiveInfinity, "above 1", "Wootton 1993, butterflies",
                Twists(soft), Twists(fine), "the delayed drive twists both strokes alike; only the dorsal asymmetry of the joints tells them apart");
            yield return new ValidationRow(
                $"{held}: smaller of the mean cambers of both strokes, negative where their signs differ, % of the chord", double.NegativeInfinity, 0, "the sign turns", "Walker et al. 2009, locust",
                Cambers(soft), Cambers(fine), "the delayed drive cambers the wing most at the turns of the stroke, by either sign; what is left over a half stroke is small and of one sign");
        }

        done();
    }

    private static double Thrusts(int substeps) => 100 * Thrust(Fly(true, substeps, 0)) / Thrust(Fly(false, substeps, 0));

    // Means over the patches of the right wing, within a twentieth of a beat of the middle of each stroke.
    private static (double Down, double Up) Attacks(FlightModel model, TrimTable table)
    {
        using var flight = new FreeFlight(model, table, new FlightCondition(k_Speed, 0f));
        var command = FlightCommand.Fly(new float3(0f, 0f, k_Speed), 0f);
        WingHandle wing = flight.Wings[0];
        flight.World.RecordPatches(wing, true);
        var down = new List<double>();
        var up = new List<double>();
        while (flight.Beats < k_Beats)
        {
            flight.Step(command, 1f / (32f * flight.World.Read(wing).Frequency));
            WingReading reading = flight.World.Read(wing);
            double turn = reading.Phase / (2 * Math.PI);
            List<double> stroke = Math.Abs(turn - 0.25) < 0.05 ? down : Math.Abs(turn - 0.75) < 0.05 ? up : null;
            if (flight.Beats >= k_Beats / 2)
                stroke?.Add(Enumerable.Range(0, reading.PatchCount).Average(patch => math.degrees((double)reading.PatchAngleOfAttack(patch))));
        }

        return (down.Average(), up.Average());
    }

    private static FlightRecord Fly(bool rigid, int substeps, double pitch) => TetheredFlight.Fly(new FlightPlan
    {
        Species = "monarch",
        Speed = k_Speed,
        PitchDegrees = pitch,
        Substeps = substeps,
        Column = rigid ? ComparisonColumn.RigidWing : ComparisonColumn.FullModel,
    });

    // Mean force ahead of a level body; the unit cancels.
    private static double Thrust(FlightRecord flight) => flight.Wings[0].Frames.Average(frame => frame.AirForce.z);

    private static double Twists(FlightRecord flight) => Largest(flight, false) / Largest(flight, true);

    private static double Largest(FlightRecord flight, bool down) =>
        Half(flight, down).Max(frame => Math.Abs(flight.Wings[0].Measurement.Twist(frame.Positions)));

    // The product over its size, times the smaller of both: below 0 where the sign turns, and how far.
    private static double Cambers(FlightRecord flight)
    {
        double down = Mean(flight, true), up = Mean(flight, false);
        return 100 * Math.Sign(down * up) * Math.Min(Math.Abs(down), Math.Abs(up));
    }

    private static double Mean(FlightRecord flight, bool down) => Half(flight, down).Average(frame => flight.Wings[0].Measurement.Camber(frame.Positions));

    private static IEnumerable<RecordedFrame> Half(FlightRecord flight, bool down) => flight.Wings[0].Frames.Where(frame => frame.Phase < Math.PI == down);
}
