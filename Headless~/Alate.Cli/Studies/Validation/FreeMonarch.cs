using Alate.Flight;

namespace Alate.Cli;

/// <summary>The catalogue's monarch in the climb that was measured.</summary>
internal static class FreeMonarch
{
    /// <summary>Speed and climb of the measured monarch, m/s.</summary>
    private const float k_ClimbingSpeed = 1.28f, k_Climb = 0.75f;

    private static readonly FlightCondition s_Climb = new(k_ClimbingSpeed, k_Climb);

    /// <summary>Trim of the measured climb with the body held still, which closes at any fineness of time.</summary>
    /// <param name="substeps">Of a beat.</param>
    /// <param name="start">Where to begin; null for none.</param>
    /// <param name="measured">Pitch of the thorax and stroke plane off the vertical, radians.</param>
    /// <param name="force">Up and ahead over the weight, of the beat of the trim at the measured pitch and stroke plane.</param>
    /// <returns>The trim; null where it does not close.</returns>
    public static TrimState Climb(int substeps, TrimState start, (double Pitch, double Plane) measured, out (double Up, double Ahead) force)
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        TrimmedFlight.Refine(model, parameters => substeps);
        using var solver = new TrimSolver(model) { HoldsStill = true };
        TrimState trim = solver.Solve(s_Climb, start ?? solver.Start(), out double[] residual);
        TrimState animal = trim.Copy();
        animal.z[0] = measured.Pitch;
        animal.z[3] = measured.Plane - measured.Pitch;
        double[] left = solver.Residual(animal, s_Climb, out _);
        force = (1 + left[0], left[1]);
        return TrimSolver.Norm(residual) < TrimSolver.Closed ? trim : null;
    }

    /// <summary>
    /// Half of the range of the pitch in the climb, radians, where the body bobs by the forces of its beat: at the species' substeps, and
    /// from there at more.
    /// </summary>
    /// <param name="fineness">Factor on the species' substeps.</param>
    /// <param name="left">Largest part of what lift, thrust and pitching moment then lack, over weight and weight times wing
    /// length.</param>
    public static (double Bob, double Fine) ClimbingBobs(int fineness, out double left)
    {
        using FlightModel model = CatalogueFlight.CreateModel(InsectCatalogue.Find("monarch"));
        TrimState climbing = MeasuredClimb(model, out _);
        left = double.NaN;
        if (climbing == null)
            return (double.NaN, double.NaN);
        TrimmedFlight.Refine(model, parameters => fineness * parameters.substepsPerBeat);
        using var solver = new TrimSolver(model);
        TrimState fine = solver.Solve(s_Climb, climbing, out double[] residual);
        left = TrimSolver.Norm(residual);
        return (climbing.PitchBob, fine.PitchBob);
    }

    /// <summary>Trim of the monarch in the climb that Kang and Sridhar measured; null where it does not close.</summary>
    public static TrimState MeasuredClimb(FlightModel model, out string missing)
    {
        using var solver = new TrimSolver(model);
        using var climbs = new TrimTable([k_ClimbingSpeed], [0f, k_Climb / 3, k_Climb * 2 / 3, k_Climb]);
        var bake = new TrimBake(model);
        TrimState climbing = bake.Trims(solver, climbs)[0, 3];
        missing = bake.Problems[0, 3];
        return climbing;
    }
}
