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

    /// <summary>Gives an insect file the value, also where a variant has one of its own.</summary>
    /// <param name="file">All numbers of the insect; it stays as it is.</param>
    /// <param name="variant">Word of the variant that flies.</param>
    /// <param name="value">The value.</param>
    /// <returns>The file with the value.</returns>
    /// <exception cref="UserException">The insect has no such number.</exception>
    public JsonPlace In(JsonPlace file, string variant, double value)
    {
        string[] path = Key[OfInsect.Length..].Split('.');
        string text = ((decimal)value).ToString(CultureInfo.InvariantCulture);
        JsonPlace changed = With(file, path, text)
            ?? throw new UserException($"The insect has no number '{Key}'; 'species NAME --json FILE' writes all that it has.");
        return With(changed, [InsectKeys.Variants, variant, .. path], text) ?? changed;
    }

    // The value with a number at the end of a path changed, sharing all else; null where there is none.
    private static JsonPlace With(JsonPlace place, ReadOnlySpan<string> path, string number)
    {
        if (path.IsEmpty)
            return place.Kind == JsonKind.Number ? new JsonPlace(JsonKind.Number, place.Path, place.Line, number) : null;
        List<(string Key, JsonPlace Value)> members = [.. place.Members];
        List<JsonPlace> items = [.. place.Items];
        string word = path[0];
        int member = members.FindIndex(one => one.Key == word);
        if (member < 0 && !(int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out member) && member < items.Count))
            return null;
        JsonPlace changed = With(place.IsObject ? members[member].Value : items[member], path[1..], number);
        if (changed == null)
            return null;
        if (place.IsObject)
            members[member] = (word, changed);
        else
            items[member] = changed;
        return new JsonPlace(place.Kind, place.Path, place.Line, place.Text, members, items);
    }

    // Nine digits: so that a table says 0.1, not 0.1000000000000001.
    private static double Rounded(double value) =>
        double.Parse(value.ToString("G9", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
}
