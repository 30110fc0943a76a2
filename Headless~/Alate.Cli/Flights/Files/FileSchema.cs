using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>The keys of a kind of file as a JSON Schema, which editors check and complete by, and as the manual's tables.</summary>
/// <param name="root">The whole file.</param>
/// <param name="fileName">Name of the schema's file.</param>
/// <param name="title">What such a file is called.</param>
/// <param name="description">What it is for, in a sentence.</param>
internal sealed class FileSchema(ObjectShape root, string fileName, string title, string description)
{
    /// <summary>Schema of insect files.</summary>
    public static FileSchema Insect { get; } = new(
        InsectKeys.File, "insect-file.schema.json", "Insect file", "An insect for the command line of Alate Insect Wings.");

    /// <summary>Name of the file.</summary>
    public string FileName => fileName;

    // Every kind of object, the whole file first, each once.
    private List<ObjectShape> Objects => Below(root).Distinct().ToList();

    /// <summary>The schema's text.</summary>
    public string Write()
    {
        var definitions = new JsonObject();
        foreach (ObjectShape kind in Objects.Skip(1))
            definitions[kind.Name] = ShapeSchema.Definition(kind);
        JsonObject file = ShapeSchema.Definition(root);
        file.Insert(0, "$schema", "https://json-schema.org/draft/2020-12/schema");
        file.Insert(1, "title", title);
        file.Insert(2, "description", description);
        file["$defs"] = definitions;
        return PrettyJson.Write(file);
    }

    /// <summary>Tables of the manual: a heading and a table for each kind of object.</summary>
    public string WriteTables()
    {
        WingPreset monarch = InsectCatalogue.Monarch();
        var text = new StringBuilder();
        foreach (ObjectShape kind in Objects)
        {
            bool hasNumbers = kind.Keys.Any(key => key is PresetKey);
            text.Append($"\n### {Title(kind.Name)}\n\n");
            text.Append(MarkdownTable([
                hasNumbers ? ["key", "value", "a monarch's", "what it says"] : ["key", "value", "what it says"],
                .. kind.Keys.Select(key => Row(key, hasNumbers, monarch)),
            ]));
        }

        UnityEngine.Object.DestroyImmediate(monarch);
        return text.Append('\n').ToString();
    }

    // "variantWing" is "Variant wing".
    private static string Title(string name) => char.ToUpperInvariant(name[0])
        + string.Concat(name[1..].Select(letter => char.IsUpper(letter) ? " " + char.ToLowerInvariant(letter) : letter.ToString()));

    private static string[] Row(FileKey key, bool hasNumbers, WingPreset monarch)
    {
        string name = $"`{key.Name}`" + (key.IsNeeded ? ", needed" : "");
        return hasNumbers
            ? [name, key.Shape.Words, key is PresetKey number ? Value(number, monarch) : "", key.Help]
            : [name, key.Shape.Words, key.Help];
    }

    private static string Value(PresetKey key, WingPreset preset) => JsonText.Line(FileValue.Of(key.Of(preset)));

    private static string MarkdownTable(IReadOnlyList<IReadOnlyList<string>> rows) => string.Concat(
        rows.Select((row, k) => $"| {string.Join(" | ", row)} |\n" + (k == 0 ? $"{string.Concat(row.Select(_ => "|---"))}|\n" : "")));

    private static IEnumerable<ObjectShape> Below(FileShape shape) =>
        (shape is ObjectShape one ? [one] : Enumerable.Empty<ObjectShape>()).Concat(shape.Inner.SelectMany(Below));
}
