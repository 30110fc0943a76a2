namespace Alate.Cli;

/// <summary>A study file as it stands.</summary>
internal sealed class StudyFile
{
    /// <summary>End of the name of such a file.</summary>
    public const string Ending = ".study.json";

    private const int k_UsualSteps = 5, k_UsualCount = 64;

    private StudyFile(string path, string text, JsonPlace root)
    {
        Path = path;
        Text = text;
        Insect = root[StudyKeys.Insect].Text;
        if (KnownSpecies.IsFile(Insect))
            Insect = System.IO.Path.Combine(System.IO.Path.GetDirectoryName(path) ?? "", Insect);
        Options = root[StudyKeys.Options]?.Items.Select(word => word.Text).ToArray() ?? [];
        Design = root[StudyKeys.Design]?.Text ?? StudyDesign.Grid;
        Count = (int)(Number(root[StudyKeys.Count]) ?? k_UsualCount);
        Seed = (uint)(Number(root[StudyKeys.Seed]) ?? 1);
        if (Design == StudyDesign.Grid && root[StudyKeys.Count] is { } count)
            throw count.Wrong("a grid has as many runs as its values make; 'steps' of a parameter says how many those are");
        Parameters = root[StudyKeys.Parameters].Items.Select(Parameter).ToList();
        JsonPlace twice = root[StudyKeys.Parameters].Items.FirstOrDefault(
            one => Parameters.Count(other => other.Key == one[StudyKeys.Key].Text) > 1);
        if (twice != null)
            throw twice.Wrong($"'{twice[StudyKeys.Key].Text}' is changed twice");
        Measures = root[StudyKeys.Measures]?.Items.Select(measure => measure.Text).Distinct().ToList()
            ?? (IsFree ? FreeStudy.Usual : SpotStudy.Usual);
        Repeats = (int)(Number(root[StudyKeys.Repeats]) ?? 1);
        if (Repeats > 1 && !IsFree)
            throw root[StudyKeys.Repeats].Wrong("a flight on the spot is the same each time; '--free' in the options flies freely");
        Most = root[StudyKeys.Best]?[StudyKeys.Most].Text;
        Least = root[StudyKeys.Best]?[StudyKeys.Least].Text;
        Goal = GoalOf(root);
    }

    /// <summary>Path of the file.</summary>
    public string Path { get; }

    /// <summary>All of it.</summary>
    public string Text { get; }

    /// <summary>A species, or the path of an insect file.</summary>
    public string Insect { get; }

    /// <summary>Words of <c>fly</c>.</summary>
    public IReadOnlyList<string> Options { get; }

    /// <summary>One of <see cref="StudyDesign.Names"/>.</summary>
    public string Design { get; }

    /// <summary>True where the flights are free, false where they are on the spot.</summary>
    public bool IsFree => Options.Contains("--free");

    /// <summary>Flights of a run.</summary>
    public int Repeats { get; }

    /// <summary>Points of a design other than a grid.</summary>
    public int Count { get; }

    /// <summary>Seed of the Latin hypercube.</summary>
    public uint Seed { get; }

    /// <summary>Numbers that are changed.</summary>
    public IReadOnlyList<StudyParameter> Parameters { get; }

    /// <summary>Names of what is measured.</summary>
    public IReadOnlyList<string> Measures { get; }

    /// <summary>Measure that should be large, and one that should be small; null for none.</summary>
    public string Most { get; }

    /// <inheritdoc cref="Most"/>
    public string Least { get; }

    /// <summary>True where some runs are better than others.</summary>
    public bool LooksForBest => Most != null || Goal != null;

    /// <summary>Aim of a search; null of another design.</summary>
    public StudyGoal Goal { get; }

    /// <summary>Reads a file.</summary>
    /// <exception cref="UserException">It is none; the message names the line, the key and what is allowed.</exception>
    public static StudyFile Read(string path)
    {
        string all = TextFile.Read(path, text => text.ReadToEnd());
        try
        {
            var root = JsonPlace.Read(new StringReader(all));
            StudyKeys.File.Check(root);
            return new StudyFile(path, all, root);
        }
        catch (FormatException problem)
        {
            throw new UserException($"{path}: {problem.Message}");
        }
    }

    private StudyGoal GoalOf(JsonPlace root)
    {
        JsonPlace goal = root[StudyKeys.Goal], best = root[StudyKeys.Best];
        bool isSearch = Design == StudyDesign.Search;
        if (isSearch != (goal != null))
            throw (goal ?? root).Wrong($"the design '{StudyDesign.Search}' and '{StudyKeys.Goal}' need one another");
        if (!isSearch)
            return null;
        if (best != null)
            throw best.Wrong($"a search has a '{StudyKeys.Goal}' in its place");
        JsonPlace most = goal[StudyKeys.Most], least = goal[StudyKeys.Least];
        if ((most == null) == (least == null))
            throw goal.Wrong($"it takes either '{StudyKeys.Most}' or '{StudyKeys.Least}'");
        return new StudyGoal((most ?? least).Text, most != null, goal[StudyKeys.Where]?.Items.Select(Bound).ToList() ?? []);
    }

    private static StudyBound Bound(JsonPlace place)
    {
        double least = Number(place[StudyKeys.Least]) ?? double.NegativeInfinity,
            most = Number(place[StudyKeys.Most]) ?? double.PositiveInfinity;
        if (double.IsInfinity(least) && double.IsInfinity(most))
            throw place.Wrong($"it takes '{StudyKeys.Least}', '{StudyKeys.Most}' or both");
        return least <= most
            ? new StudyBound(place[StudyKeys.Measure].Text, least, most)
            : throw place[StudyKeys.Most].Wrong($"'{StudyKeys.Most}' must be at least '{StudyKeys.Least}'");
    }

    private StudyParameter Parameter(JsonPlace place)
    {
        string key = place[StudyKeys.Key].Text;
        IEnumerable<string> known = IsFree ? FreeStudy.Changeable : SpotStudy.Changeable.Select(number => number.Name);
        if (!key.StartsWith(StudyParameter.OfInsect, StringComparison.Ordinal) && !known.Contains(key))
        {
            throw place[StudyKeys.Key].Wrong($"there is no number {Quote.Of(key)} of {(IsFree ? "a free" : "the")} flight. Known: "
                + $"{string.Join(", ", known)}; those of the insect begin with 'insect.'");
        }

        bool isLogarithmic = place[StudyKeys.Scale]?.Text == StudyKeys.Logarithmic,
            isWhole = place[StudyKeys.Whole]?.Kind == JsonKind.True || key == FlightNumbers.Substeps.Name
                || key == FlightNumbers.Seed.Name;
        if (place[StudyKeys.Values] is { } listed)
        {
            JsonPlace other = new[] { StudyKeys.From, StudyKeys.To, StudyKeys.Steps, StudyKeys.Scale }.Select(word => place[word])
                .FirstOrDefault(found => found != null);
            if (Design != StudyDesign.Grid)
            {
                throw listed.Wrong(
                    $"'{StudyKeys.Values}' is for a grid; the design '{Design}' takes '{StudyKeys.From}' and '{StudyKeys.To}'");
            }

            if (other != null)
                throw other.Wrong($"it does not go with '{StudyKeys.Values}'");
            double[] values = listed.Items.Select(item => Number(item).Value).ToArray();
            return new StudyParameter(key, values.Min(), values.Max(), false, isWhole, values);
        }

        double from = Number(Needed(place, StudyKeys.From)).Value, to = Number(Needed(place, StudyKeys.To)).Value;
        if (!(from < to))
            throw place[StudyKeys.To].Wrong($"'{StudyKeys.To}' must be more than '{StudyKeys.From}'");
        if (isLogarithmic && !(from > 0))
            throw place[StudyKeys.From].Wrong("equal ratios need values above 0");
        if (Design != StudyDesign.Grid && place[StudyKeys.Steps] is { } steps)
            throw steps.Wrong($"it is for a grid; the design '{Design}' takes '{StudyKeys.Count}' points");
        var parameter = new StudyParameter(key, from, to, isLogarithmic, isWhole, [from, to]);
        int count = (int)(Number(place[StudyKeys.Steps]) ?? k_UsualSteps);
        return Design != StudyDesign.Grid ? parameter : parameter with
        {
            Values = Enumerable.Range(0, count).Select(k => parameter.At((double)k / (count - 1))).Distinct().ToArray(),
        };
    }

    private static JsonPlace Needed(JsonPlace place, string key) =>
        place[key] ?? throw place.Wrong($"'{key}' is missing, or '{StudyKeys.Values}'");

    private static double? Number(JsonPlace value) =>
        value == null ? null : double.Parse(value.Text, NumberStyles.Float, CultureInfo.InvariantCulture);
}
