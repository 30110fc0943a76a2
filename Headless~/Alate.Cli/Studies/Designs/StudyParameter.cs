using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>A number that a study changes, and the values it takes.</summary>
/// <param name="Key">A number of the flight, or <c>insect.</c> and a path in the insect file.</param>
/// <param name="From">The least value.</param>
/// <param name="To">The most.</param>
/// <param name="IsLogarithmic">Equal ratios of values are equally likely.</param>
/// <param name="IsWhole">Whole numbers alone.</param>
/// <param name="Values">Those of a grid, in order.</param>
internal sealed record StudyParameter(
    string Key, double From, double To, bool IsLogarithmic, bool IsWhole, IReadOnlyList<double> Values)
{
    /// <summary>Beginning of the key of an insect's number.</summary>
    public const string OfInsect = "insect.";

    /// <summary>Numbers of a flight on the spot.</summary>
    public static IReadOnlyList<FlightNumber> OfFlight { get; } =
    [
        FlightNumbers.Speed, FlightNumbers.Climb, FlightNumbers.Pitch, FlightNumbers.Wind, FlightNumbers.Lag, FlightNumbers.Elasticity,
        FlightNumbers.Amplitude, FlightNumbers.Frequency, FlightNumbers.Substeps,
    ];

    /// <summary>True for a number of the insect.</summary>
    public bool IsOfInsect => Key.StartsWith(OfInsect, StringComparison.Ordinal);

    /// <summary>Name of its column.</summary>
    public string Column => Key.Replace(' ', '_');

    /// <summary>The value at a place between both ends.</summary>
    /// <param name="share">0 to 1.</param>
    public double At(double share)
    {
        double value = IsLogarithmic ? From * Math.Pow(To / From, share) : From + (To - From) * share;
        return IsWhole ? Math.Round(value) : Rounded(value);
    }

    /// <summary>Gives a flight the value of a number of its own.</summary>
    /// <exception cref="UserException">It is out of range.</exception>
    public FlightPlan In(FlightPlan plan, double value)
    {
        FlightNumber number = OfFlight.First(known => known.Name == Key);
        return value >= number.Min && value <= number.Max
            ? number.In(plan, value)
            : throw new UserException(FormattableString.Invariant(
                $"'{Key}' must lie between {number.Min} and {number.Max}; it is {value}."));
    }

    /// <summary>Gives an insect file the value, also where a variant has one of its own.</summary>
    /// <param name="file">All numbers of the insect.</param>
    /// <param name="variant">Word of the variant that flies.</param>
    /// <param name="value">The value.</param>
    /// <exception cref="UserException">The insect has no such number.</exception>
    public void In(JsonNode file, string variant, double value)
    {
        string[] path = Key[OfInsect.Length..].Split('.');
        if (!TrySet(file, path, value))
            throw new UserException($"The insect has no number '{Key}'; 'species NAME --json FILE' writes all that it has.");
        if (file[InsectKeys.Variants]?[variant] is { } own)
            TrySet(own, path, value);
    }

    private static bool TrySet(JsonNode place, string[] path, double value)
    {
        foreach (string word in path[..^1])
            place = Member(place, word);
        if (Member(place, path[^1]) is not JsonValue number || number.GetValueKind() != System.Text.Json.JsonValueKind.Number)
            return false;
        number.ReplaceWith(JsonValue.Create((decimal)value));
        return true;
    }

    private static JsonNode Member(JsonNode place, string word) => place switch
    {
        JsonObject all => all[word],
        JsonArray list when int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int index) && index < list.Count =>
            list[index],
        _ => null,
    };

    // Nine digits: so that a table says 0.1, not 0.1000000000000001.
    private static double Rounded(double value) =>
        double.Parse(value.ToString("G9", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
}
