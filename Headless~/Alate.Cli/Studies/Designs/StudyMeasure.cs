namespace Alate.Cli;

/// <summary>A number that a study takes of each run.</summary>
/// <param name="Name">As summary.json has it; before a point the wing that it is of.</param>
/// <param name="Of">Reads it.</param>
internal sealed record StudyMeasure(string Name, Func<FlightSummary, double> Of)
{
    /// <summary>Those of a study that names none.</summary>
    public static IReadOnlyList<string> Usual { get; } =
        ["lift_over_weight", "positive_power_w", "twist_pp_deg", "edge_stretch_max_pct"];

    private static readonly StudyMeasure[] s_OfFlight =
    [
        new("lift_over_weight", summary => summary.LiftOverWeight),
        new("lift_n", summary => summary.Flight.Plan.ToWorld(summary.MeanForce).y),
        new("thrust_n", summary => summary.Flight.Plan.ToWorld(summary.MeanForce).z),
        new("power_w", summary => summary.MeanPower.Air),
        new("positive_power_w", summary => summary.MeanPower.Positive),
        new("negative_power_w", summary => summary.MeanPower.Negative),
        new("newton_iterations_mean", summary => summary.NewtonIterationsMean),
        new("resets", summary => summary.Resets),
    ];

    /// <summary>Measures of one wing.</summary>
    private static IEnumerable<(string Name, Func<WingSummary, double> Of)> OfWing =>
    [
        .. WingMeasure.All.Select(measure => (measure.Key, measure.Of)),
        ("leading_ei_n_m2", wing => wing.Stiffness.Leading), ("wing_ei_n_m2", wing => wing.Stiffness.Whole),
    ];

    /// <summary>Names of all measures.</summary>
    public static IEnumerable<string> Names => s_OfFlight.Select(measure => measure.Name).Concat(OfWing.Select(measure => measure.Name));

    /// <summary>Finds a measure.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="insect">Names of its wings, the first one first.</param>
    /// <returns>Null where there is none.</returns>
    public static StudyMeasure Find(string name, InsectDefinition insect)
    {
        if (Array.Find(s_OfFlight, measure => measure.Name == name) is { } known)
            return known;
        int dot = name.IndexOf('.'), wing = dot < 0 ? 0 : insect.Wings.ToList().FindIndex(own => own.Name == name[..dot]);
        Func<WingSummary, double> of = OfWing.FirstOrDefault(measure => measure.Name == name[(dot + 1)..]).Of;
        return wing < 0 || of == null ? null : new StudyMeasure(name, summary => of(summary.Wings[wing]));
    }
}
