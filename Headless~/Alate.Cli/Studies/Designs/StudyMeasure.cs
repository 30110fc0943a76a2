namespace Alate.Cli;

/// <summary>A number that a study takes of each flight on the spot.</summary>
/// <param name="Name">As summary.json has it; before a point the wing that it is of.</param>
/// <param name="Title">Its name and unit for charts.</param>
/// <param name="Of">Reads it.</param>
internal sealed record StudyMeasure(string Name, string Title, Func<FlightSummary, double> Of)
{
    private static readonly StudyMeasure[] s_OfFlight =
    [
        new("lift_over_weight", "lift over weight", summary => summary.LiftOverWeight),
        new("lift_n", "lift, N", summary => summary.Flight.Plan.ToWorld(summary.MeanForce).y),
        new("thrust_n", "thrust, N", summary => summary.Flight.Plan.ToWorld(summary.MeanForce).z),
        new("power_w", "power to the air, W", summary => summary.MeanPower.Air),
        new("positive_power_w", "positive power, W", summary => summary.MeanPower.Positive),
        new("negative_power_w", "negative power, W", summary => summary.MeanPower.Negative),
        new("newton_iterations_mean", "Newton iterations, mean", summary => summary.NewtonIterationsMean),
        new("resets", "resets", summary => summary.Resets),
    ];

    /// <summary>Measures of one wing.</summary>
    private static IEnumerable<WingMeasure> OfWing =>
    [
        .. WingMeasure.All, new("leading_ei_n_m2", "EI of the leading edge, N m²", wing => wing.Stiffness.Leading),
        new("wing_ei_n_m2", "EI of the wing, N m²", wing => wing.Stiffness.Whole),
    ];

    /// <summary>Names of all measures.</summary>
    public static IEnumerable<string> Names => s_OfFlight.Select(measure => measure.Name).Concat(OfWing.Select(measure => measure.Key));

    /// <summary>Finds a measure.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="insect">Names of its wings, the first one first.</param>
    /// <returns>Null where there is none.</returns>
    public static StudyMeasure Find(string name, InsectDefinition insect)
    {
        if (Array.Find(s_OfFlight, measure => measure.Name == name) is { } known)
            return known;
        int dot = name.IndexOf('.'), wing = dot < 0 ? 0 : insect.Wings.ToList().FindIndex(own => own.Name == name[..dot]);
        if (wing < 0 || OfWing.FirstOrDefault(measure => measure.Key == name[(dot + 1)..]) is not { } found)
            return null;
        string title = dot < 0 ? found.Title : $"{insect.Wings[wing].Name}: {found.Title}";
        return new StudyMeasure(name, title, summary => found.Of(summary.Wings[wing]));
    }
}
