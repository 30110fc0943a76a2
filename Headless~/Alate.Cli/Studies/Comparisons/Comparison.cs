using Alate.Flight;

namespace Alate.Cli;

/// <summary>One insect, flown once for each column.</summary>
internal sealed class Comparison
{
    private Comparison(FlightPlan plan, IReadOnlyList<ComparedFlight> flights, FlightMeans free, int phases)
    {
        Plan = plan;
        Free = free;
        Flights = flights;
        double first = SurfaceDistance.FarthestPhase(flights[0].Summary.Flight.Wings, Held.Summary.Flight.Wings);
        Phases = Enumerable.Range(0, phases).Select(k => (first + (double)k / phases) % 1.0).ToList();
    }

    public FlightPlan Plan { get; }

    /// <summary>[column]</summary>
    public IReadOnlyList<ComparedFlight> Flights { get; }

    /// <summary>The flight on the spot by the full model.</summary>
    public ComparedFlight Held => Flights.First(flight => flight.Column == ComparisonColumn.FullModel);

    /// <summary>Flight of the insect by its own wings, with the numbers of the variant flight; null where it has no trim table.</summary>
    public FlightMeans Free { get; }

    /// <summary>
    /// Rows of the picture, beats: the first is that in which the first column is farthest from the full model, the others follow evenly.
    /// </summary>
    public IReadOnlyList<double> Phases { get; }

    /// <summary>Name of the compared insect, with its variant where that is not the standard one.</summary>
    public string Name => KnownSpecies.Titled(Flights[0].Summary.Flight.Insect.DisplayName, Plan.Variant);

    /// <summary>Flies every insect by every column.</summary>
    /// <param name="plan">What to fly.</param>
    /// <param name="progress">Told how many flights are done.</param>
    public static List<Comparison> Fly(ComparisonPlan plan, Action<int> progress)
    {
        var comparisons = new List<Comparison>();
        int done = 0;
        foreach (FlightPlan flight in plan.Flights)
        {
            FlightRecord[] records = plan.Columns.Select(column =>
            {
                FlightRecord record = TetheredFlight.Fly(flight with { Column = column });
                progress(++done);
                return record;
            }).ToArray();
            FlightRecord full = records.First(record => record.Plan.Column == ComparisonColumn.FullModel);
            comparisons.Add(
                new Comparison(flight, records.Select(record => ComparedFlight.Of(record, full)).ToList(), FlyFreely(flight), plan.Phases));
        }

        return comparisons;
    }

    // As fast as the flight on the spot, or as fast as the insect flies.
    private static FlightMeans FlyFreely(FlightPlan plan)
    {
        InsectDefinition insect = plan.Definition;
        if (!insect.Variants.Contains(InsectVariant.Flight))
            return null;
        using FlightModel model = CatalogueFlight.CreateModel(insect);
        using TrimTable table = CatalogueFlight.CreateTable(insect, model);
        return table == null ? null : FlightMeans.Fly(model, table, new FlightCondition((float)Math.Min(plan.Speed, table.TopSpeed), 0f));
    }
}
