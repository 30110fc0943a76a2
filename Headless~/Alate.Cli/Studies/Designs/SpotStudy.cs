namespace Alate.Cli;

/// <summary>Flight on the spot that a study flies.</summary>
/// <param name="Plan">The flight.</param>
internal sealed record SpotStudy(FlightPlan Plan) : StudyFlight
{
    /// <summary>Numbers that a study changes.</summary>
    public static IReadOnlyList<FlightNumber> Changeable { get; } =
    [
        FlightNumbers.Speed, FlightNumbers.Climb, FlightNumbers.Pitch, FlightNumbers.Wind, FlightNumbers.Lag, FlightNumbers.Elasticity,
        FlightNumbers.Amplitude, FlightNumbers.Frequency, FlightNumbers.Substeps,
    ];

    /// <summary>Measures of a study that names none.</summary>
    public static IReadOnlyList<string> Usual { get; } =
        ["lift_over_weight", "positive_power_w", "twist_pp_deg", "edge_stretch_max_pct"];

    public override InsectDefinition Insect => Plan.Definition;

    public override InsectVariant Variant => Plan.Variant;

    public override string KnownMeasures => string.Join(", ", StudyMeasure.Names);

    public override StudyFlight Of(InsectDefinition insect) => new SpotStudy(Plan with { Definition = insect });

    public override StudyFlight With(string key, double value)
    {
        FlightNumber number = Changeable.First(known => known.Name == key);
        return new SpotStudy(number.In(Plan, Within(number, key, value)));
    }

    public override string TitleOf(string measure) => StudyMeasure.Find(measure, Insect)?.Title;

    public override void Check()
    {
        using var flight = new TetheredFlight(Plan, Alate.Cli.Insect.Of(Plan));
    }

    public override double[] Fly(IReadOnlyList<string> measures)
    {
        var summary = FlightSummary.Of(TetheredFlight.Fly(Plan));
        return [.. measures.Select(name => StudyMeasure.Find(name, Insect).Of(summary))];
    }
}
