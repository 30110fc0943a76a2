using System.CommandLine;
using System.CommandLine.Parsing;
using Alate.Flight;

namespace Alate.Cli;

/// <summary>The options of <c>fly --free</c>.</summary>
internal sealed class FreeOptions
{
    private static readonly string[] s_Pilots = ["hover", "goto", "points", "wander"];

    private const int k_MostPoints = 1000;
    private const double k_DefaultSeconds = 10;

    private readonly Option<bool> m_Free =
        new("--free") { Description = "The wings carry the insect: a flight of its own, not on the spot." };
    private readonly Option<string> m_Pilot = new("--pilot")
    {
        HelpName = "hover|goto|points|wander",
        Description = "With --free: where to. [default: hover, goto with --to, points with --points]",
    };
    private readonly Option<double[]> m_To = Numbers.Vector(FlightNumbers.To);
    private readonly Option<string> m_Points = new("--points")
    {
        HelpName = "FILE",
        Description = "With --free: a file of places, X,Y,Z in metres a line, flown one after the other.",
    };
    private readonly Option<int?> m_Seed = Numbers.OptionalCount(FlightNumbers.Seed);
    private readonly Option<double[]> m_Gust = Numbers.Vector(FlightNumbers.Gust);
    private readonly Option<double> m_Aid = Numbers.Option(FlightNumbers.Aid);
    private readonly Option<double> m_Step = Numbers.Option(FlightNumbers.Step);

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

    private Option[] Flown => [m_Pilot, m_To, m_Points, m_Seed, m_Gust, m_Aid, m_Step];

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
    public FreePlan Plan(ParseResult parsed, string species, double? seconds, string folder)
    {
        if (parsed.GetValue(m_Replay) is { } recorded)
            return PlanReplay(parsed, recorded, species, seconds, folder);
        double[] gust = parsed.GetValue(m_Gust);
        return new FreePlan
        {
            RecordFile = parsed.GetValue(m_Record),
            Options = string.Join(
                ' ', Flown.Where(option => IsGiven(parsed, option)).Select(option => parsed.GetResult(option)).Select(Said)),
            Insect = KnownSpecies.Find(
                species ?? throw new UserException($"Which species? Known: {string.Join(", ", InsectCatalogue.Names)}."),
                InsectVariant.Flight),
            Points = PointsOf(parsed, out bool wanders),
            WanderSeed = wanders ? parsed.GetValue(m_Seed) ?? (int)FlightNumbers.Seed.Default : null,
            Seconds = Math.Max(seconds ?? k_DefaultSeconds, parsed.GetValue(m_Step)),
            Gust = gust is { Length: 3 } ? new float3((float)gust[0], (float)gust[1], (float)gust[2]) : default,
            Aid = parsed.GetValue(m_Aid),
            Step = parsed.GetValue(m_Step),
            Folder = folder,
        };
    }

    private FreePlan PlanReplay(ParseResult parsed, string file, string species, double? seconds, string folder)
    {
        Option given = ((Option[])[.. Flown, m_Record]).FirstOrDefault(option => IsGiven(parsed, option));
        if (given != null || seconds != null)
            throw new UserException($"--replay takes no {given?.Name ?? "--seconds"}: the recording says it.");
        var replay = Replay.Read(file);
        if (species != null && !string.Equals(species, replay.Species.Name, StringComparison.OrdinalIgnoreCase))
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

    private List<float3> PointsOf(ParseResult parsed, out bool wanders)
    {
        double[] to = parsed.GetValue(m_To);
        string file = parsed.GetValue(m_Points);
        string pilot = parsed.GetValue(m_Pilot) ?? (file != null ? "points" : to is { Length: 3 } ? "goto" : "hover");
        if (!s_Pilots.Contains(pilot))
            throw new UserException($"--pilot takes {string.Join(", ", s_Pilots.SkipLast(1))} or {s_Pilots[^1]}, not {Quote.Of(pilot)}.");
        wanders = pilot == "wander";
        if (!wanders && parsed.GetValue(m_Seed) != null)
            throw new UserException($"--seed needs --pilot wander, not {pilot}.");
        if ((pilot != "points" && file != null) || (pilot != "goto" && to is { Length: 3 }))
            throw new UserException($"--pilot {pilot} takes no {(pilot != "points" && file != null ? "--points" : "--to")}.");
        switch (pilot)
        {
            case "hover":
                return [default];
            case "goto":
                return to is { Length: 3 }
                    ? [new float3((float)to[0], (float)to[1], (float)to[2])]
                    : throw new UserException("--pilot goto needs --to X,Y,Z.");
            case "points":
                return file == null ? throw new UserException("--pilot points needs --points FILE.") : Read(file);
            default:
                return [];
        }
    }

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
