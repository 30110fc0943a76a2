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

    /// <summary>Time of the means.</summary>
    private const double k_Seconds = 12;

    /// <summary>Flies with so many substeps of a beat, by the species' trim table.</summary>
    public static FreeMonarch Fly(int substeps)
    {
        InsectDefinition monarch = InsectCatalogue.Find("monarch");
        using FlightModel model = CatalogueFlight.CreateModel(monarch);
        using TrimTable table = CatalogueFlight.CreateTable(monarch, model);
        Refine(model, parameters => substeps);
        var level = SteadyFlight.Fly(model, table, new FlightCondition(k_Speed, 0f), k_Seconds);
        (double down, double up) = Attacks(model, table);
        return new FreeMonarch(100 * level.UpForce, 100 * level.UpSupport, level.PowerPerMass, down, up);
    }

    /// <summary>Trims of the measured climb: at the species' substeps, and from there at more.</summary>
    /// <param name="fineness">Factor on the species' substeps.</param>
    /// <param name="residual">What lift, thrust and pitching moment then lack, over weight and weight times wing length; null where the first does not close.</param>
    public static (TrimState Trim, TrimState Fine) Climb(int fineness, out double[] residual)
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        TrimState climbing = FlightFigures.MeasuredClimb(model, out _);
        residual = null;
        if (climbing == null)
            return default;
        Refine(model, parameters => fineness * parameters.substepsPerBeat);
        using var solver = new TrimSolver(model);
        return (climbing, solver.Solve(new FlightCondition(FlightFigures.k_MeasuredSpeed, FlightFigures.k_MeasuredClimb), climbing, out residual));
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
