using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Catalogue;
using Alate.Cli.Flights;

namespace Alate.Cli.Comparisons;

/// <summary>One insect, flown once for each column.</summary>
internal sealed class Comparison
{
    private Comparison(FlightPlan plan, IReadOnlyList<ComparedFlight> flights, int phases)
    {
        Plan = plan;
        Flights = flights;
        Phases = Enumerable.Range(0, phases).Select(k => (double)k / phases).ToList();
    }

    public FlightPlan Plan { get; }

    /// <summary>[column]</summary>
    public IReadOnlyList<ComparedFlight> Flights { get; }

    /// <summary>Rows of the picture, beats.</summary>
    public IReadOnlyList<double> Phases { get; }

    /// <summary>Name of the compared insect, with its variant where that is not the standard one.</summary>
    public string Name => Flights[0].Summary.Flight.Insect.DisplayName
        + (Plan.Variant == InsectVariant.Standard ? "" : $", {Plan.Variant.ToString().ToLowerInvariant()}");

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
            comparisons.Add(new Comparison(flight, records.Select(record => ComparedFlight.Of(record, full)).ToList(), plan.Phases));
        }

        return comparisons;
    }
}
