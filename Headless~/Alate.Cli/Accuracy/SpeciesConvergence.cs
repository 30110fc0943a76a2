using System;
using System.Collections.Generic;
using System.Linq;
using Alate.Cli.Flights;

namespace Alate.Cli.Accuracy;

/// <summary>Error against cost for every kind of wing of an insect, and its numbers beside their limits.</summary>
internal sealed class SpeciesConvergence
{
    private static readonly string[] s_Measures = ["twist_pp_deg", "camber_min_pct", "camber_max_pct", "tip_bend_pp_deg", "tip_bend_max_deg", "lag_deg", "tip_lag_deg"];

    private SpeciesConvergence(FlightPlan plan, string displayName, IReadOnlyList<WingConvergence> wings)
    {
        Plan = plan;
        DisplayName = displayName;
        Wings = wings;
    }

    public FlightPlan Plan { get; }

    public string DisplayName { get; }

    /// <summary>[kind of wing]</summary>
    public IReadOnlyList<WingConvergence> Wings { get; }

    /// <summary>Measures all insects.</summary>
    /// <param name="plan">What to fly.</param>
    /// <param name="progress">Told how many insects are done.</param>
    public static List<SpeciesConvergence> Measure(ConvergencePlan plan, Action<int> progress)
    {
        var measured = new List<SpeciesConvergence>();
        foreach (FlightPlan flight in plan.Flights)
        {
            measured.Add(Measure(flight));
            progress(measured.Count);
        }

        return measured;
    }

    private static SpeciesConvergence Measure(FlightPlan plan)
    {
        List<(FlightPlan Plan, List<double> Errors)> tried = Errors(plan, out FlightRecord converged);
        FlightRecord atDefaults = Flight.Fly(plan);
        List<double> old = new SchemeFlights(Version01.Of(plan) with { Patches = plan.Patches })
            .ErrorsAt(Version01.Of(plan).Substeps.Value);
        double[] lift = [Lift(plan), Lift(plan with { Substeps = ConvergencePlan.ReferenceSubsteps })];
        FlightSummary now = FlightSummary.Of(atDefaults), limit = FlightSummary.Of(converged);
        var wings = new List<WingConvergence>();
        for (int kind = 0; kind < now.Wings.Count; kind++)
        {
            InsectWing wing = atDefaults.Insect.Wings[kind];
            double[] cost = BeatCost.Measure(wing, tried.Select(flight => flight.Plan).Append(Version01.Of(plan)));
            List<ConvergencePoint> points = tried.Select((flight, k) => new ConvergencePoint(
                flight.Plan.TimeScheme.Value, flight.Plan.Substeps.Value, flight.Errors[kind], cost[k] / cost[^1])).ToList();
            int substeps = plan.ParametersOf(wing.Species).substepsPerBeat;
            wings.Add(new WingConvergence(
                now.Wings[kind].Name, substeps, points,
                points.First(point => point.Scheme == TimeScheme.SecondOrder && point.Substeps == substeps),
                new ConvergencePoint(TimeScheme.BackwardEuler, Version01.Of(plan).Substeps.Value, old[kind], 1.0),
                Values(now.Wings[kind], limit.Wings[kind], kind == 0 ? lift : null).ToList()));
        }

        return new SpeciesConvergence(plan, atDefaults.Insect.DisplayName, wings);
    }

    // Every scheme at every number of substeps; the limit is the default scheme's.
    private static List<(FlightPlan Plan, List<double> Errors)> Errors(FlightPlan plan, out FlightRecord converged)
    {
        converged = null;
        var tried = new List<(FlightPlan, List<double>)>();
        foreach (TimeScheme scheme in ConvergencePlan.Schemes)
        {
            FlightPlan by = plan with { TimeScheme = scheme };
            var flights = new SchemeFlights(by);
            converged ??= flights.Reference;
            foreach (int substeps in ConvergencePlan.Substeps)
                tried.Add((by with { Substeps = substeps }, flights.ErrorsAt(substeps)));
        }

        return tried;
    }

    private static IEnumerable<ConvergedValue> Values(WingSummary now, WingSummary limit, double[] lift)
    {
        foreach (WingMeasure measure in WingMeasure.All.Where(measure => s_Measures.Contains(measure.Key)))
            yield return new ConvergedValue(measure.Key, measure.Title, measure.Of(now), measure.Of(limit));
        if (lift != null)
            yield return new ConvergedValue("lift_over_weight", FormattableString.Invariant($"lift over weight at pitch {ConvergencePlan.LiftPitch}°"), lift[0], lift[1]);
    }

    private static double Lift(FlightPlan plan) => FlightSummary.Of(Flight.Fly(plan with { PitchDegrees = ConvergencePlan.LiftPitch })).LiftOverWeight;
}
