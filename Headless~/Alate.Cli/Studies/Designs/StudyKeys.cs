namespace Alate.Cli;

/// <summary>Every key of a study file, described once: the reader, the schema and the manual's tables go by it.</summary>
internal static class StudyKeys
{
    /// <summary>Version of the format.</summary>
    public const int Version = 1;

    /// <summary>Most parameters, most values of one, and most runs.</summary>
    public const int MostParameters = 10, MostValues = 1000, MostRuns = 1_000_000;

    public const string SchemaKey = "$schema", VersionKey = "version", Insect = "insect", Options = "options", Design = "design",
        Count = "count", Seed = "seed", Parameters = "parameters", Key = "key", From = "from", To = "to", Steps = "steps",
        Values = "values", Scale = "scale", Whole = "whole", Measures = "measures", Best = "best", Most = "most", Least = "least",
        Linear = "linear", Logarithmic = "logarithmic", Goal = "goal", Where = "where", Measure = "measure",
        Repeats = "repeats";

    private static readonly NumberShape s_Number = new(-1e9m, 1e9m, "");

    /// <summary>A number that is changed.</summary>
    public static ObjectShape Parameter { get; } = new(
        "parameter",
        new FileKey(
            Key, new TextShape("a number of the flight, such as 'pitch', or of the insect, such as 'insect.beat.frequencyHertz'", 200),
            "What is changed: a number of the flight (" + string.Join(", ", SpotStudy.Changeable.Select(number => number.Name))
            + "), of a free one (" + string.Join(", ", FreeStudy.Changeable)
            + "), or `insect.` and the path of a number in the insect file.")
        {
            IsNeeded = true,
        },
        new FileKey(From, s_Number, "The least value."),
        new FileKey(To, s_Number, "The most."),
        new FileKey(Steps, new NumberShape(2, MostValues, "", isWhole: true), "Values of a grid between them; 5 without it."),
        new FileKey(Values, new ListShape(s_Number, 1, MostValues, $"a list of 1 to {MostValues} numbers"),
            "The values of a grid one by one, in place of `from`, `to` and `steps`."),
        new FileKey(Scale, new ChoiceShape(Linear, Logarithmic),
            "Equal differences, or equal ratios, of values between `from` and `to`; linear without it."),
        new FileKey(Whole, new ChoiceShape(), "Whole numbers alone."));

    /// <summary>A direction in which a measure is better.</summary>
    private static readonly ObjectShape s_Best = new(
        "best",
        new FileKey(Most, new TextShape("a measure", 100), "The more of this measure the better.") { IsNeeded = true },
        new FileKey(Least, new TextShape("a measure", 100), "The less of this one the better.") { IsNeeded = true });

    private static readonly ObjectShape s_Bound = new(
        "bound",
        new FileKey(Measure, new TextShape("a measure", 100), "The measure.") { IsNeeded = true },
        new FileKey(Least, s_Number, "The least that it may be."),
        new FileKey(Most, s_Number, "The most."));

    private static readonly ObjectShape s_Goal = new(
        "goal",
        new FileKey(Most, new TextShape("a measure", 100), "The more of this measure the better; this or `least`."),
        new FileKey(Least, new TextShape("a measure", 100), "The less of this one the better."),
        new FileKey(Where, new ListShape(s_Bound, 1, 20, "a list of 1 to 20 bounds"),
            "Ranges in which measures must lie. While no run keeps to them, the one that misses them least is the best."));

    /// <summary>Schema of study files.</summary>
    public static FileSchema Schema => new(
        File, "study-file.schema.json", "Study file", "A study of an insect for the command line of Alate Insect Wings.");

    /// <summary>The whole file.</summary>
    public static ObjectShape File { get; } = new(
        "study",
    [
        new FileKey(SchemaKey, new TextShape("the address of the schema"), "Address of the schema, for editors; not read."),
        new FileKey(VersionKey, new NumberShape(Version, Version, "", isWhole: true), "Version of this format.") { IsNeeded = true },
        new FileKey(Insect, new TextShape("a species, or the path of an insect file from the folder of this file", 400),
            "The insect: a species of the catalogue, or an insect file.") { IsNeeded = true },
        new FileKey(Options, new ListShape(new TextShape("a word of the command line", 400), 0, 100, "a list of up to 100 words"),
            "Options of `fly` for every run, a word each, such as `\"--speed\", \"0\"`. With `\"--free\"` the insect flies freely."),
        new FileKey(Design, new ChoiceShape([.. StudyDesign.Names]),
            "How the values are chosen: `grid` takes each value with each; `latin-hypercube`, `sobol` and `saltelli` take `count` points, "
            + "the last so that sensitivities follow; `search` looks for the best run by `goal`. Grid without it."),
        new FileKey(Count, new NumberShape(1, MostRuns, "", isWhole: true),
            "Points of a design other than a grid; `saltelli` flies each with every parameter taken from elsewhere, besides. 64 without "
            + "it."),
        new FileKey(Seed, new NumberShape(1, 2147483647, "", isWhole: true),
            "Seed of the Latin hypercube and of the search; 1 without it."),
        new FileKey(Repeats, new NumberShape(1, 1000, "", isWhole: true),
            "Free flights of each run, with one seed after the other; measures are their means, and with `_sd`, `_least` and "
            + "`_most` behind their names their spread. 1 without it."),
        new FileKey(Parameters, new ListShape(Parameter, 1, MostParameters, $"a list of 1 to {MostParameters} parameters"),
            "What is changed.") { IsNeeded = true },
        new FileKey(Measures, new ListShape(new TextShape("a measure", 100), 1, 100, "a list of 1 to 100 measures"),
            "What is measured of each run: names of summary.json, of another wing than the first as `hind wing.twist_pp_deg`. Without it "
            + "lift_over_weight, positive_power_w, twist_pp_deg and edge_stretch_max_pct; of free flights tumble_s, lowest_m, "
            + "velocity_error_m_s and positive_power_w."),
        new FileKey(Goal, s_Goal, "What a search looks for."),
        new FileKey(Best, s_Best, "Two measures whose best compromises, the Pareto front, are marked and drawn."),
    ]);
}
