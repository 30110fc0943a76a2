using Alate.Flight;

namespace Alate.Cli;

/// <summary>Free flight that a study flies, once or several times with one seed after the other.</summary>
/// <param name="Plan">The flight.</param>
/// <param name="Repeats">Flights of a run.</param>
internal sealed record FreeStudy(FreePlan Plan, int Repeats) : StudyFlight
{
    private const string k_Axes = "xyz";

    private static readonly (string Name, string Title, Func<FreeRecord, double> Of)[] s_Measures =
    [
        ("tumbles", "tumbles", flight => flight.Tumbles.Count),
        ("tumble_s", "time of tumbling, s", flight => flight.Tumbles.Sum(tumble => tumble.seconds)),
        ("tumble_longest_s", "longest tumble, s", flight => flight.Tumbles.Select(tumble => tumble.seconds).DefaultIfEmpty().Max()),
        ("velocity_error_m_s", "velocity error, m/s", flight => flight.VelocityError),
        ("end_x_m", "end to the right, m", flight => flight.Moments[^1].Position.x),
        ("end_y_m", "end above the start, m", flight => flight.Moments[^1].Position.y),
        ("end_z_m", "end ahead, m", flight => flight.Moments[^1].Position.z),
        ("lowest_m", "lowest place, m", flight => flight.Moments.Min(at => at.Position.y)),
        ("farthest_m", "farthest place, m", flight => flight.Moments.Max(at => math.length(at.Position))),
        ("lift_over_weight", "lift over weight", flight => flight.LiftOverWeight),
        ("upstroke_share", "share of the upstroke", flight => flight.UpstrokeShare),
        ("power_w", "power to the air, W", flight => flight.MeanPower.Air),
        ("positive_power_w", "positive power, W", flight => flight.MeanPower.Positive),
        ("negative_power_w", "negative power, W", flight => flight.MeanPower.Negative),
        ("aid_w", "power of the aid, W", flight => flight.AidPower),
    ];

    private static readonly (string Ending, string Title, Func<double[], double> Of)[] s_Spreads =
    [
        ("", "", values => values.Average()),
        ("_least", ", least", values => values.Min()),
        ("_most", ", most", values => values.Max()),
        ("_sd", ", standard deviation", values =>
        {
            double mean = values.Average();
            return Math.Sqrt(values.Sum(value => (value - mean) * (value - mean)) / Math.Max(values.Length - 1, 1));
        }),
    ];

    /// <summary>Numbers that a study changes: of vectors each axis is one.</summary>
    public static IReadOnlyList<string> Changeable { get; } =
    [
        FlightNumbers.Seed.Name, FlightNumbers.Erratic.Name, FlightNumbers.Aid.Name, FlightNumbers.Step.Name,
        .. Along(FlightNumbers.Gust), .. Along(FlightNumbers.To),
    ];

    /// <summary>Measures of a study that names none.</summary>
    public static IReadOnlyList<string> Usual { get; } = ["tumble_s", "lowest_m", "velocity_error_m_s", "positive_power_w"];

    public override InsectDefinition Insect => Plan.Insect;

    public override InsectVariant Variant => InsectVariant.Flight;

    public override string KnownMeasures => string.Join(", ", s_Measures.Select(measure => measure.Name))
        + (Repeats > 1 ? $"; each also with {string.Join(" or ", Spreads.Skip(1).Select(spread => spread.Ending))} behind it" : "");

    // One flight has its mean alone.
    private IEnumerable<(string Ending, string Title, Func<double[], double> Of)> Spreads =>
        s_Spreads.Take(Repeats > 1 ? s_Spreads.Length : 1);

    public override StudyFlight Of(InsectDefinition insect) => this with { Plan = Plan with { Insect = insect } };

    public override StudyFlight With(string key, double value)
    {
        int axis = k_Axes.IndexOf(key[^1]);
        FlightNumber number = new[] { FlightNumbers.Seed, FlightNumbers.Erratic, FlightNumbers.Aid, FlightNumbers.Step }
            .FirstOrDefault(known => known.Name == key) ?? (key[..^2] == FlightNumbers.Gust.Name ? FlightNumbers.Gust : FlightNumbers.To);
        FreePilot pilot = FreePilot.All.FirstOrDefault(one => one.Takes.Contains(number.Option));
        if (pilot != null && pilot != Plan.Pilot)
            throw new UserException($"'{key}' goes with --pilot {pilot.Name}, not with --pilot {Plan.Pilot.Name}.");
        value = Within(number, key, value);
        if (number == FlightNumbers.Gust)
            return this with { Plan = Plan with { Gust = Moved(Plan.Gust, axis, value) } };
        if (number == FlightNumbers.To)
            return this with { Plan = Plan with { Points = [Moved(Plan.Points[^1], axis, value)] } };
        return this with
        {
            Plan = number == FlightNumbers.Seed ? Plan with { Seed = (int)Math.Round(value) }
                : number == FlightNumbers.Erratic ? Plan with { Erratic = value }
                : number == FlightNumbers.Aid ? Plan with { Aid = value }
                : Plan with { Step = value },
        };
    }

    public override string TitleOf(string measure) => Find(measure) is { Of: not null } found ? found.Title : null;

    public override void Check()
    {
        using FlightModel model = CatalogueFlight.CreateModel(Plan.Insect);
        using TrimTable table = TrimmedFlight.TableOf(Plan.Insect, model);
    }

    public override double[] Fly(IReadOnlyList<string> measures)
    {
        FreeRecord[] flights =
            [.. Enumerable.Range(0, Repeats).Select(k => FreeRun.Fly(Plan with { Seed = Plan.Seed + k }, _ => { }))];
        return [.. measures.Select(name => Find(name).Of(flights))];
    }

    private (string Title, Func<FreeRecord[], double> Of) Find(string name)
    {
        foreach ((string measure, string title, Func<FreeRecord, double> of) in s_Measures)
        {
            foreach ((string ending, string spread, Func<double[], double> over) in Spreads)
            {
                if (name == measure + ending)
                    return (title + spread, flights => over(Array.ConvertAll(flights, flight => of(flight))));
            }
        }

        return default;
    }

    private static IEnumerable<string> Along(FlightNumber vector) => k_Axes.Select(axis => $"{vector.Name}-{axis}");

    private static float3 Moved(float3 vector, int axis, double value)
    {
        vector[axis] = (float)value;
        return vector;
    }
}
