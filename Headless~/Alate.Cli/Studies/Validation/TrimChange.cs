using Alate.Flight;

namespace Alate.Cli;

/// <summary>An insect that is held still in the trim by which it flies, with one thing changed.</summary>
internal sealed record TrimChange
{
    /// <summary>Factor on the insect's mass for which it is trimmed.</summary>
    public float Mass { get; init; } = 1f;

    /// <summary>Factor on the frequency about which it is trimmed.</summary>
    public float Frequency { get; init; } = 1f;

    /// <summary>Lift and drag of the wings for which it is trimmed; null for the preset's.</summary>
    public CoefficientSet? Coefficients { get; init; }

    /// <summary>True where it is trimmed in air at rest; false in the air of the wake of its table.</summary>
    public bool StillAir { get; init; }

    /// <summary>Trims and flies; angles and forces are not numbers where the trim does not close.</summary>
    /// <param name="species">Name.</param>
    /// <param name="speed">Level, m/s.</param>
    /// <param name="substeps">Of a beat.</param>
    public HalfStrokes Fly(string species, float speed, int substeps)
    {
        InsectDefinition insect = InsectCatalogue.Find(species);
        using FlightModel own = CatalogueFlight.CreateModel(insect);
        using TrimTable table = CatalogueFlight.CreateTable(insect, own);
        TrimmedFlight.Refine(own, _ => substeps);
        foreach (FlightWing wing in own.Wings)
        {
            WingParameters parameters = wing.Parameters;
            parameters.maxFrequency *= Frequency;
            parameters.options.coefficients = Coefficients ?? parameters.options.coefficients;
            wing.Parameters = parameters;
        }

        using var model = new FlightModel(own.Wings, insect.FlightParts, Mass * own.Mass, own.FluidDensity, own.GravityShare);
        using var solver = new TrimSolver(model) { HoldsStill = true };
        var condition = new FlightCondition(speed, 0f);
        var start = TrimState.Read(table.PointNear(condition.Speed, condition.Climb), own.Frequency);
        if (StillAir)
            Array.Clear(start.inflow);
        TrimState trim = solver.Solve(condition, start, out double[] residual);
        if (TrimSolver.Norm(residual) >= TrimSolver.Closed)
            return new HalfStrokes(double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, double.NaN, double.NaN);
        return HalfStrokes.Of(TetheredFlight.Fly(new FlightPlan
        {
            Species = species,
            Variant = InsectVariant.Flight,
            Speed = speed,
            PitchDegrees = math.degrees(trim.Pitch),
            Drive = trim.Drive(model.Frequency),
            Substeps = substeps,
            RecordsAir = true,
            Coefficients = Coefficients,
            Inflow = new FlightInflow(insect.Wings.Select((wing, pair) => (wing.Name, Air: trim.Inflow[pair] * own.Wings[2 * pair].Length))
                .ToDictionary(wing => (wing.Name, WingSide.Right), wing => wing.Air)),
        }), model.Weight);
    }
}
