using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>A run as its summary.json has it, to be flown again.</summary>
/// <param name="Version">Version of the package that flew it.</param>
/// <param name="Insect">The insect with all its numbers.</param>
/// <param name="Record">Its command and files.</param>
internal sealed record FlownRun(string Version, InsectDefinition Insect, RunRecord Record)
{
    /// <summary>Keys of summary.json.</summary>
    public const string VersionKey = "version", CommandKey = "command", InsectKey = "insect", InsectFileKey = "insect_file",
        InputsKey = "inputs", FileKey = "file", HashKey = "sha256";

    /// <summary>Reads the file.</summary>
    /// <exception cref="UserException">It is no summary of a run, or a file that was read is another one now.</exception>
    public static FlownRun Read(string path)
    {
        string all = TextFile.Read(path, text => text.ReadToEnd());
        try
        {
            var root = JsonPlace.Read(new StringReader(all));
            JsonPlace insect = Member(root, InsectKey, JsonKind.Object);
            string own = root[InsectFileKey] == null ? null : Text(root, InsectFileKey);
            var words = Member(root, CommandKey, JsonKind.List).Items.Select(Text).ToList();
            var inputs = Member(root, InputsKey, JsonKind.List).Items
                .Select(input => new InputHash(Text(input, FileKey), Text(input, HashKey))).ToList();
            foreach (InputHash input in inputs.Where(input => input.File != own))
                Check(input);
            InsectDefinition flown = InsectFile.Read(insect, own ?? path, InputFiles.Instance);
            (flown.FilePath, flown.FileText) = (own, own == null ? null : JsonNode.Parse(all)[InsectKey].ToJsonString());
            return new FlownRun(Text(root, VersionKey), flown, new RunRecord(words) { Inputs = inputs });
        }
        catch (FormatException problem)
        {
            throw new UserException($"{path}: {problem.Message}");
        }
    }

    private static void Check(InputHash input)
    {
        string now = ReadFiles.HashOf(input.File);
        if (now != input.Sha256)
        {
            throw new UserException(
                $"'{input.File}' is another file than the one that was flown: its SHA-256 is {now}, not {Quote.Of(input.Sha256)[1..^1]}.");
        }
    }

    private static JsonPlace Member(JsonPlace place, string key, JsonKind kind)
    {
        JsonPlace member = place[key]
            ?? throw place.Wrong($"'{key}' is missing, so that it is no summary of 'fly' that can be flown again");
        return member.Kind == kind ? member : throw member.Wrong($"it must not be {member.Shown}");
    }

    private static string Text(JsonPlace place, string key) => Text(Member(place, key, JsonKind.Text));

    private static string Text(JsonPlace value) =>
        value.Kind == JsonKind.Text ? value.Text : throw value.Wrong($"it must be a text, not {value.Shown}");
}
