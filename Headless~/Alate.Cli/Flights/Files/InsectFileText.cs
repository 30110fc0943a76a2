using System.Text.Encodings.Web;
using System.Text.Json;
using System.Text.Json.Nodes;
using Alate.Flight;

namespace Alate.Cli;

/// <summary>Writes an insect as an insect file that says all of its numbers.</summary>
internal static class InsectFileText
{
    private static readonly JsonSerializerOptions s_Plain = new() { Encoder = JavaScriptEncoder.UnsafeRelaxedJsonEscaping };

    /// <summary>
    /// The file of an insect of the catalogue, or of another file with all that this has from elsewhere; paths are as the file has them.
    /// </summary>
    public static string Write(InsectDefinition insect)
    {
        JsonNode said = insect.FileText == null ? null : JsonNode.Parse(insect.FileText);
        List<WingPreset> standard = Presets(insect, InsectVariant.Standard);
        JsonObject file = Numbers(insect, standard, null);
        file.Insert(0, InsectKeys.VersionKey, InsectKeys.Version);
        file.Insert(1, InsectKeys.Name, insect.Name);
        file.Insert(2, InsectKeys.DisplayName, insect.DisplayName);
        file.Insert(3, InsectKeys.Like, (string)said?[InsectKeys.Like] ?? insect.Name);
        foreach (WingDefinition wing in insect.Wings)
        {
            JsonNode own = file[InsectKeys.Wings][wing.Name];
            own[InsectKeys.Hinge] = FileNodes.Place(wing.Hinge);
            Copy(said?[InsectKeys.Wings]?[wing.Name], own, InsectKeys.Mesh, InsectKeys.Skeleton, InsectKeys.Texture, InsectKeys.Flexural,
                InsectKeys.Torsional, InsectKeys.VeinWidths);
        }

        file[InsectKeys.Body] = new JsonObject
        {
            [InsectKeys.Parts] = new JsonArray(insect.FlightParts.Select(Part).ToArray<JsonNode>()),
        };
        Copy(said?[InsectKeys.Body], file[InsectKeys.Body], InsectKeys.Scale, InsectKeys.Mesh, InsectKeys.MeshUnit);
        Copy(said, file, InsectKeys.Kinematics, InsectKeys.Trims);
        file[InsectKeys.Sources] = new JsonArray(insect.Sources.Select(Source).ToArray<JsonNode>());
        var variants = new JsonObject();
        foreach (InsectVariant variant in insect.Variants.Skip(1))
        {
            List<WingPreset> presets = Presets(insect, variant);
            variants[InsectKeys.Word(variant)] = Numbers(insect, presets, standard);
            presets.ForEach(UnityEngine.Object.DestroyImmediate);
        }

        file[InsectKeys.Variants] = variants;
        standard.ForEach(UnityEngine.Object.DestroyImmediate);
        return Pretty(file);
    }

    // What no preset has.
    private static void Copy(JsonNode said, JsonNode file, params string[] keys)
    {
        foreach (string key in keys)
        {
            if (said?[key] is { } value)
                file[key] = value.DeepClone();
        }
    }

    // Numbers that all wings have in common stand once; where there is a standard, only those that differ from it.
    private static JsonObject Numbers(InsectDefinition insect, List<WingPreset> presets, List<WingPreset> standard)
    {
        var file = new JsonObject();
        List<JsonObject> wings = presets.ConvertAll(preset => new JsonObject());
        foreach (PresetKey key in InsectKeys.OfInsect)
            Add(key, presets, standard, file, null);
        foreach (PresetKey key in InsectKeys.OfWing)
            Add(key, presets, standard, null, wings);
        foreach ((string name, string help, IReadOnlyList<PresetKey> keys) in InsectKeys.Groups)
        {
            var common = new JsonObject();
            List<JsonObject> own = presets.ConvertAll(preset => new JsonObject());
            foreach (PresetKey key in keys)
                Add(key, presets, standard, common, own);
            if (common.Count > 0)
                file[name] = common;
            for (int k = 0; k < own.Count; k++)
            {
                if (own[k].Count > 0)
                    wings[k][name] = own[k];
            }
        }

        if (standard == null || wings.Exists(wing => wing.Count > 0))
        {
            var named = new JsonObject();
            for (int k = 0; k < wings.Count; k++)
                named[insect.Wings[k].Name] = wings[k];
            file[InsectKeys.Wings] = named;
        }

        return file;
    }

    private static void Add(PresetKey key, List<WingPreset> presets, List<WingPreset> standard, JsonObject common, List<JsonObject> own)
    {
        List<string> values = presets.ConvertAll(preset => FileNodes.Of(key.Of(preset)).ToJsonString());
        if (standard != null && values.SequenceEqual(standard.Select(preset => FileNodes.Of(key.Of(preset)).ToJsonString())))
            return;
        if (own == null || common != null && values.TrueForAll(value => value == values[0]))
        {
            common[key.Name] = FileNodes.Of(key.Of(presets[0]));
            return;
        }

        for (int k = 0; k < presets.Count; k++)
            own[k][key.Name] = FileNodes.Of(key.Of(presets[k]));
    }

    private static List<WingPreset> Presets(InsectDefinition insect, InsectVariant variant) =>
        insect.Wings.Select(wing => wing.CreatePreset(ModelReading.Physical, variant)).ToList();

    private static JsonObject Part(BodyEllipsoid part) => new()
    {
        [InsectKeys.Centre] = FileNodes.Place(part.centre),
        [InsectKeys.HalfAxes] = FileNodes.Place(part.halfAxes),
        [InsectKeys.MassShare] = FileNodes.Number(part.share, 1m),
    };

    private static JsonObject Source(InsectSource source)
    {
        var said = new JsonObject
        {
            [InsectKeys.Quantity] = source.Quantity,
            [InsectKeys.Value] = source.Value,
            [InsectKeys.Source] = source.Source,
        };
        if (source.Variant != InsectVariant.Standard)
            said[InsectKeys.Variant] = InsectKeys.Word(source.Variant);
        return said;
    }

    /// <summary>JSON as a person would write it: two spaces a level, plain values of short lists and objects on one line.</summary>
    public static string Pretty(JsonNode node)
    {
        var text = new StringBuilder();
        Append(text, node, 0);
        return text.Append('\n').ToString();
    }

    private static void Append(StringBuilder text, JsonNode node, int depth)
    {
        const int k_Line = 100;
        string line = Line(node);
        if (node is not JsonObject and not JsonArray || node is JsonArray && line.Length + 2 * depth <= k_Line
            || depth > 1 && line.Length + 2 * depth <= k_Line && node is JsonObject small && small.All(member => IsPlain(member.Value)))
        {
            text.Append(line);
            return;
        }

        (string open, string close) = node is JsonObject ? ("{", "}") : ("[", "]");
        text.Append(open);
        int count = 0;
        foreach ((string key, JsonNode value) in node is JsonObject whole
            ? whole.Select(member => (member.Key, member.Value)) : ((JsonArray)node).Select(item => ((string)null, item)))
        {
            text.Append(count++ == 0 ? "\n" : ",\n").Append(' ', 2 * (depth + 1));
            if (key != null)
                text.Append(Name(key));
            Append(text, value, depth + 1);
        }

        text.Append('\n').Append(' ', 2 * depth).Append(close);
    }

    private static string Name(string key) => JsonSerializer.Serialize(key, s_Plain) + ": ";

    private static bool IsPlain(JsonNode node) => node is JsonValue || node is JsonArray list && list.All(item => item is JsonValue);

    private static string Line(JsonNode node) => node switch
    {
        JsonObject whole => whole.Count == 0
            ? "{}"
            : $"{{ {string.Join(", ", whole.Select(member => Name(member.Key) + Line(member.Value)))} }}",
        JsonArray list => $"[{string.Join(", ", list.Select(Line))}]",
        null => "null",
        _ => node.ToJsonString(s_Plain),
    };
}
