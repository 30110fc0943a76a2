using Alate.Flight;

namespace Alate.Cli;

/// <summary>Flights on the spot with the beat and the pitch by which an insect flies freely.</summary>
internal static class TrimmedFlight
{
    /// <summary>Returns a plan with the variant, the beat and the pitch of the trim at its speed and climb.</summary>
    /// <param name="plan">Names the species, the speed, the climb and the substeps; null substeps are the species'.</param>
    /// <exception cref="UserException">The insect does not fly by its own wings, or not there.</exception>
    public static FlightPlan Of(FlightPlan plan)
    {
        InsectDefinition insect = KnownSpecies.With(plan.Definition, InsectVariant.Flight);
        using FlightModel model = CatalogueFlight.CreateModel(insect);
        using TrimTable table = TableOf(insect, model);
        if (plan.Substeps is int substeps)
            Refine(model, _ => substeps);
        using var solver = new TrimSolver(model) { HoldsStill = true };
        var condition = new FlightCondition((float)plan.Speed, (float)plan.Climb);
        var start = TrimState.Read(table.PointNear(condition.Speed, condition.Climb), model.Frequency);
        TrimState trim = solver.Solve(condition, start, out double[] residual);
        return TrimSolver.Norm(residual) < TrimSolver.Closed
            ? plan with
            {
                Variant = InsectVariant.Flight,
                PitchDegrees = math.degrees(trim.Pitch),
                Drive = trim.Drive(model.Frequency),
            }
            : throw new UserException(string.Create(CultureInfo.InvariantCulture,
                $"The {insect.DisplayName} does not fly at {plan.Speed:0.###} m/s ahead and {plan.Climb:0.###} m/s up: ")
                + solver.Missing(condition, residual));
    }

    /// <summary>The plan at its speed, or at the top speed of the insect's table where that is less.</summary>
    /// <exception cref="UserException">The insect has no table.</exception>
    public static FlightPlan WithinTable(FlightPlan plan)
    {
        InsectDefinition insect = KnownSpecies.With(plan.Definition, InsectVariant.Flight);
        using FlightModel model = CatalogueFlight.CreateModel(insect);
        using TrimTable table = TableOf(insect, model);
        return plan with { Speed = Math.Min(plan.Speed, table.TopSpeed) };
    }

    /// <summary>Trim table of a species.</summary>
    /// <exception cref="UserException">It has none.</exception>
    public static TrimTable TableOf(InsectDefinition insect, FlightModel model) => CatalogueFlight.CreateTable(insect, model)
        ?? throw new UserException($"The {insect.DisplayName} has no trim table for these numbers: "
            + "'trim' says at which speeds it flies, and 'trim --bake' makes the table.");

    /// <summary>Sets the substeps of all wings.</summary>
    public static void Refine(FlightModel model, Func<WingParameters, int> substeps)
    {
        foreach (FlightWing wing in model.Wings)
        {
            WingParameters parameters = wing.Parameters;
            parameters.substepsPerBeat = substeps(parameters);
            wing.Parameters = parameters;
        }
    }
}
