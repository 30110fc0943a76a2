using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Figures;
using Alate.Cli.FreeFlights;
using Alate.Flight;
using Unity.Mathematics;

namespace Alate.Cli.Validation;

/// <summary>What the catalogue's monarch does when its own wings carry it level at 1.3 m/s. Degrees and per cent.</summary>
/// <param name="UpForce">Share of the upstroke in the mean size of the force.</param>
/// <param name="UpSupport">Share of the upstroke in the upward impulse.</param>
/// <param name="Power">To the air, W/kg.</param>
/// <param name="DownAttack">Mean angle of attack in the middle of the downstroke.</param>
/// <param name="UpAttack">In the middle of the upstroke.</param>
internal sealed record FreeMonarch(double UpForce, double UpSupport, double Power, double DownAttack, double UpAttack)
{
    private const float k_Speed = 1.3f;
    private const int k_Beats = 60;

    /// <summary>Flies with so many substeps of a beat, by the species' trim table.</summary>
    public static FreeMonarch Fly(int substeps)
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using FlightModel model = CatalogueFlight.CreateModel(monarch);
        using TrimTable table = CatalogueFlight.CreateTable(monarch, model);
        Refine(model, parameters => substeps);
        var level = SteadyFlight.Fly(model, table, new FlightCondition(k_Speed, 0f));
        (double down, double up) = Attacks(model, table);
        return new FreeMonarch(100 * level.UpForce, 100 * level.UpSupport, level.PowerPerMass, down, up);
    }

    /// <summary>Attitude in the measured climb.</summary>
    /// <param name="fineness">Factor on the substeps of the species.</param>
    /// <param name="missing">What the trim lacks where it does not close.</param>
    /// <returns>Mean pitch of the thorax, and the stroke plane off the vertical, degrees; not numbers where the trim does not close.</returns>
    public static (double Pitch, double Plane) Climb(int fineness, out string missing)
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        Refine(model, parameters => fineness * parameters.substepsPerBeat);
        TrimState climbing = FlightFigures.MeasuredClimb(model, out missing);
        double pitch = climbing?.Pitch ?? double.NaN, tilt = climbing?.Tilt ?? double.NaN;
        return (180 / Math.PI * pitch, 180 / Math.PI * (pitch + tilt));
    }

    private static void Refine(FlightModel model, Func<WingParameters, int> substeps)
    {
        foreach (FlightWing wing in model.Wings)
        {
            WingParameters parameters = wing.Parameters;
            parameters.substepsPerBeat = substeps(parameters);
            wing.Parameters = parameters;
        }
    }

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
}
