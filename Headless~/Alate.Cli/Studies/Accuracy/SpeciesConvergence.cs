namespace Alate.Cli;

/// <summary>Error against cost for every kind of wing of an insect, and its numbers beside their limits.</summary>
internal sealed class SpeciesConvergence
{
    private static readonly string[] s_Measures =
        ["twist_pp_deg", "camber_min_pct", "camber_max_pct", "tip_bend_pp_deg", "tip_bend_max_deg", "lag_deg", "tip_lag_deg"];

    internal SpeciesConvergence(FlightPlan plan, string displayName, IReadOnlyList<WingConvergence> wings)
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
        var insect = Insect.Of(plan);
        FlightPlan defaults = Taken(plan with { Substeps = plan.ParametersOf(insect.Wings[0].Preset).substepsPerBeat }, insect);
        FlightPlan old = Taken(plan.AsVersion01(), insect);
        List<FlightPlan> plans = Plans(plan, defaults, insect);
        List<List<double>> errors = Errors(plan, plans, out FlightRecord converged);
        List<double> oldErrors = new SchemeFlights(old with { Patches = plan.Patches }).ErrorsAt(old.Substeps.Value);
        FlightSummary now = FlightSummary.Of(TetheredFlight.Fly(defaults)), limit = FlightSummary.Of(converged);
        double[] lift = [Lift(defaults), Lift(plan with { Substeps = ConvergencePlan.ReferenceSubsteps })];
        var wings = new List<WingConvergence>();
        for (int kind = 0; kind < now.Wings.Count; kind++)
        {
            double[] times = BeatCost.NanosecondsOf(insect.Wings[kind], plans.Append(old));
            var points = plans
                .Select((one, k) => new ConvergencePoint(one.TimeScheme.Value, one.Substeps.Value, errors[k][kind], times[k] / times[^1]))
                .ToList();
            wings.Add(new WingConvergence(
                now.Wings[kind].Name, points,
                points.First(point => point.Scheme == ConvergencePlan.Schemes[0] && point.Substeps == defaults.Substeps),
                new ConvergencePoint(TimeScheme.BackwardEuler, old.Substeps.Value, oldErrors[kind], 1.0),
                Values(now.Wings[kind], limit.Wings[kind], kind == 0 ? lift : null).ToList()));
        }

        return new SpeciesConvergence(plan, insect.DisplayName, wings);
    }

    // By every scheme, at every number of substeps once, that of the defaults among them.
    private static List<FlightPlan> Plans(FlightPlan plan, FlightPlan defaults, Insect insect)
    {
        var substeps = ConvergencePlan.Substeps.Select(count => Taken(plan with { Substeps = count }, insect).Substeps.Value)
            .Append(defaults.Substeps.Value).Distinct().Order().ToList();
        return ConvergencePlan.Schemes
            .SelectMany(scheme => substeps.Select(count => plan with { TimeScheme = scheme, Substeps = count })).ToList();
    }

    // The plan that asks for as many substeps as its wings take, so that no step is more than one of them.
    private static FlightPlan Taken(FlightPlan plan, Insect insect) =>
        plan with { Substeps = insect.Wings.Max(wing => BeatCost.SubstepsOf(wing, plan)) };

    // [plan][kind of wing]; the limit is the default scheme's.
    private static List<List<double>> Errors(FlightPlan plan, List<FlightPlan> plans, out FlightRecord converged)
    {
        var flights = ConvergencePlan.Schemes.ToDictionary(
            scheme => scheme, scheme => new SchemeFlights(plan with { TimeScheme = scheme }));
        converged = flights[ConvergencePlan.Schemes[0]].Reference;
        return plans.ConvertAll(one => flights[one.TimeScheme.Value].ErrorsAt(one.Substeps.Value));
    }

    private static IEnumerable<ConvergedValue> Values(WingSummary now, WingSummary limit, double[] lift)
    {
        foreach (WingMeasure measure in WingMeasure.All.Where(measure => s_Measures.Contains(measure.Key)))
            yield return new ConvergedValue(measure.Key, measure.Title, measure.Of(now), measure.Of(limit));
        if (lift != null)
        {
            yield return new ConvergedValue(
                "lift_over_weight", FormattableString.Invariant($"lift over weight at pitch {ConvergencePlan.LiftPitch}°"),
                lift[0], lift[1]);
        }
    }

    private static double Lift(FlightPlan plan) =>
        FlightSummary.Of(TetheredFlight.Fly(plan with { PitchDegrees = ConvergencePlan.LiftPitch })).LiftOverWeight;
}
