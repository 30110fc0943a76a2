using System.CommandLine;
using System.CommandLine.Parsing;
using Alate.Flight;

namespace Alate.Cli;

/// <summary>The options of <c>fly --free</c>.</summary>
internal sealed class FreeOptions
{
    private const int k_MostPoints = 1000;
    private const double k_DefaultSeconds = 10;

    private readonly Option<bool> m_Free =
        new("--free") { Description = "The wings carry the insect: a flight of its own, not on the spot." };
    private readonly Option<string> m_Pilot = new("--pilot")
    {
        HelpName = string.Join('|', FreePilot.All.Select(pilot => pilot.Name)),
        Description = "With --free: where to. [default: hover, goto with --to, points with --points]",
    };
    private readonly Option<double[]> m_To = Numbers.Vector(FlightNumbers.To);
    private readonly Option<string> m_Points = new("--points")
    {
        HelpName = "FILE",
        Description = "With --free: a file of places, X,Y,Z in metres a line, flown one after the other.",
    };
    private readonly Option<int?> m_Seed = Numbers.OptionalCount(FlightNumbers.Seed);
    private readonly Option<double> m_Erratic = Numbers.Option(FlightNumbers.Erratic);
    private readonly Option<double[]> m_Gust = Numbers.Vector(FlightNumbers.Gust);
    private readonly Option<double> m_Aid = Numbers.Option(FlightNumbers.Aid);
    private readonly Option<double> m_Step = Numbers.Option(FlightNumbers.Step);

    private readonly Option<bool> m_Unguarded = new("--unguarded")
    {
        Description = "With --free: follows commands that the insect cannot fly: backwards, sideways, straight down, by jumps it tumbles.",
    };

    private readonly Option<string> m_Record = new("--record")
    {
        HelpName = "FILE",
        Description = "With --free: a file that gets all that the flight met, to be flown again.",
    };

    private readonly Option<string> m_Replay = new("--replay")
    {
        HelpName = "FILE",
        Description = "With --free: a recorded flight, of --record or of a scene, that is flown again.",
    };

    /// <summary>Option that names the file of a recording.</summary>
    public Option Record => m_Record;

    private Option[] Flown => [m_Pilot, m_To, m_Points, m_Seed, m_Erratic, m_Gust, m_Aid, m_Step, m_Unguarded];

    public void AddTo(Command command)
    {
        foreach (Option option in (Option[])[m_Free, .. Flown, m_Record, m_Replay])
            command.Options.Add(option);
    }

    /// <summary>Returns true where the flight is free.</summary>
    /// <exception cref="UserException">It is not, but options say how it is to be.</exception>
    public bool IsFree(ParseResult parsed)
    {
        if (parsed.GetValue(m_Free))
            return true;
        Option given = ((Option[])[.. Flown, m_Record, m_Replay]).FirstOrDefault(option => IsGiven(parsed, option));
        return given == null ? false : throw new UserException($"{given.Name} needs --free.");
    }

    /// <summary>Makes the plan of the flight that the user asked for.</summary>
    /// <exception cref="UserException">Options that exclude or need each other, or a file that has no places.</exception>
    /// <param name="parsed">The command line.</param>
    /// <param name="species">What it names.</param>
    /// <param name="seconds">Time of the flight; null for the default.</param>
    /// <param name="folder">Of the files; null for the default.</param>
    /// <param name="flown">The insect of a run that is flown again; null for that of the name.</param>
    public FreePlan Plan(ParseResult parsed, string species, double? seconds, string folder, InsectDefinition flown = null)
    {
        if (parsed.GetValue(m_Replay) is { } recorded)
            return PlanReplay(parsed, recorded, species, seconds, folder, flown);
        double[] gust = parsed.GetValue(m_Gust);
        return new FreePlan
        {
            RecordFile = parsed.GetValue(m_Record),
            Options = string.Join(
                ' ', Flown.Where(option => IsGiven(parsed, option)).Select(option => parsed.GetResult(option)).Select(Said)),
            Insect = KnownSpecies.With(
                flown ?? KnownSpecies.Find(species ?? throw new UserException($"Which species? Known: {KnownSpecies.Names}.")),
                InsectVariant.Flight),
            Pilot = PilotOf(parsed),
            Points = PointsOf(parsed),
            Seed = parsed.GetValue(m_Seed) ?? (int)FlightNumbers.Seed.Default,
            Erratic = parsed.GetValue(m_Erratic),
            Seconds = Math.Max(seconds ?? k_DefaultSeconds, parsed.GetValue(m_Step)),
            Gust = gust is { Length: 3 } ? new float3((float)gust[0], (float)gust[1], (float)gust[2]) : default,
            Aid = parsed.GetValue(m_Aid),
            GuardsCommands = !parsed.GetValue(m_Unguarded),
            Step = parsed.GetValue(m_Step),
            Folder = folder,
        };
    }

    /// <summary>Makes the plan of a flight that a study flies with other numbers.</summary>
    /// <exception cref="UserException">Options that exclude or need each other, a replay or a recording.</exception>
    public FreePlan PlanOfStudy(ParseResult parsed, InsectDefinition insect, double? seconds) =>
        ((Option[])[m_Record, m_Replay]).FirstOrDefault(option => IsGiven(parsed, option)) is { } given
            ? throw new UserException($"A study takes no {given.Name}.")
            : Plan(parsed, insect.Name, seconds, null, insect);

    private FreePlan PlanReplay(
        ParseResult parsed, string file, string species, double? seconds, string folder, InsectDefinition flown)
    {
        Option given = ((Option[])[.. Flown, m_Record]).FirstOrDefault(option => IsGiven(parsed, option));
        if (given != null || seconds != null)
            throw new UserException($"--replay takes no {given?.Name ?? "--seconds"}: the recording says it.");
        InsectDefinition own = flown ?? (KnownSpecies.IsFile(species) ? KnownSpecies.Find(species) : null);
        var replay = Replay.Read(file, own);
        if (species != null && !string.Equals(own?.Name ?? species, replay.Species.Name, StringComparison.OrdinalIgnoreCase))
            throw new UserException($"'{file}' was flown by the {replay.Species.Name}, not by '{species}'.");
        FlightRecording recording = replay.Recording;
        return new FreePlan
        {
            Insect = replay.Species,
            Replay = replay,
            Seconds = recording.Seconds,
            Folder = folder,
        };
    }

    private static bool IsGiven(ParseResult parsed, Option option) => parsed.GetResult(option) is { Implicit: false };

    private static string Said(OptionResult option) =>
        string.Join(' ', option.Tokens.Select(token => token.Value).Prepend(option.Option.Name));

    private FreePilot PilotOf(ParseResult parsed)
    {
        FreePilot implied = FreePilot.All.FirstOrDefault(one => one.NeedsIt && IsGiven(parsed, OptionOf(one.Takes[0]))) ?? FreePilot.Hover;
        FreePilot pilot = parsed.GetValue(m_Pilot) is { } name ? FreePilot.Find(name) : implied;
        if (pilot.NeedsIt && !IsGiven(parsed, OptionOf(pilot.Takes[0])))
            throw new UserException($"--pilot {pilot.Name} needs {pilot.Takes[0]} {OptionOf(pilot.Takes[0]).HelpName}.");
        foreach (FreePilot other in FreePilot.All.Where(one => one != pilot))
        {
            if (Array.Find(other.Takes, name => IsGiven(parsed, OptionOf(name))) is { } given)
                throw new UserException($"--pilot {pilot.Name} takes no {given}; it goes with --pilot {other.Name}.");
        }

        return pilot;
    }

    private Option OptionOf(string name) => Flown.First(option => option.Name == name);

    private List<float3> PointsOf(ParseResult parsed) => parsed.GetValue(m_Points) is { } file ? Read(file)
        : parsed.GetValue(m_To) is { Length: 3 } to ? [new float3((float)to[0], (float)to[1], (float)to[2])]
        : [];

    private static List<float3> Read(string file)
    {
        string[] lines = TextFile.Read(file, text => text.ReadToEnd().Split('\n'));
        var points = new List<float3>();
        for (int k = 0; k < lines.Length; k++)
        {
            if (string.IsNullOrWhiteSpace(lines[k]))
                continue;
            string[] words = lines[k].Split(',');
            float[] place = new float[words.Length];
            for (int word = 0; word < words.Length; word++)
            {
                if (words.Length != 3 || !float.TryParse(words[word], NumberStyles.Float, CultureInfo.InvariantCulture, out place[word])
                    || !(Math.Abs(place[word]) <= FlightNumbers.To.Max))
                {
                    throw new UserException($"{file}, line {k + 1}: {Quote.Of(lines[k].Trim())} is no place; X,Y,Z in metres, each up to "
                        + $"{FlightNumbers.To.Max}, are needed.");
                }
            }

            points.Add(new float3(place[0], place[1], place[2]));
        }

        return points.Count is > 0 and <= k_MostPoints
            ? points
            : throw new UserException($"{file} has {points.Count} places; 1 to {k_MostPoints} are needed.");
    }
}
