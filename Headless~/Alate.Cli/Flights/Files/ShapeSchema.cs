using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>Writes descriptions of values as JSON Schemas.</summary>
internal static class ShapeSchema
{
    /// <summary>The schema of a value; an object refers to its definition.</summary>
    public static JsonObject Of(FileShape shape) => shape switch
    {
        ChoiceShape { Choices.Count: 0 } => new JsonObject { ["type"] = "boolean" },
        ChoiceShape choice => new JsonObject { ["enum"] = Words(choice.Choices) },
        ListShape list => new JsonObject
        {
            ["type"] = "array",
            ["items"] = Of(list.Item),
            ["minItems"] = list.Least,
            ["maxItems"] = list.Most,
        },
        MapShape map => new JsonObject
        {
            ["type"] = "object",
            ["propertyNames"] = Of(map.Name),
            ["additionalProperties"] = Of(map.Item),
            ["minProperties"] = 1,
            ["maxProperties"] = MapShape.Most,
        },
        NumberShape number => new JsonObject
        {
            ["type"] = number.IsWhole ? "integer" : "number",
            ["minimum"] = JsonValue.Create(number.Least),
            ["maximum"] = JsonValue.Create(number.Most),
        },
        ObjectShape kind => new JsonObject { ["$ref"] = "#/$defs/" + kind.Name },
        TextShape text => Text(text),
        _ => throw new ArgumentOutOfRangeException(nameof(shape), shape, "There is no schema of this shape."),
    };

    /// <summary>The schema behind the name of a kind of object.</summary>
    public static JsonObject Definition(ObjectShape kind)
    {
        var properties = new JsonObject();
        foreach (FileKey key in kind.Keys)
        {
            JsonObject schema = Of(key.Shape);
            schema.Insert(0, "description", key.Help);
            properties[key.Name] = schema;
        }

        var whole = new JsonObject { ["type"] = "object", ["properties"] = properties, ["additionalProperties"] = false };
        string[] needed = kind.Keys.Where(key => key.IsNeeded).Select(key => key.Name).ToArray();
        if (needed.Length > 0)
            whole["required"] = Words(needed);
        return whole;
    }

    private static JsonObject Text(TextShape text)
    {
        var schema = new JsonObject { ["type"] = "string", ["minLength"] = 1, ["maxLength"] = text.Most };
        if (text.Pattern != null)
            schema["pattern"] = text.Pattern;
        return schema;
    }

    private static JsonArray Words(IEnumerable<string> words) => new(words.Select(word => (JsonNode)word).ToArray());
}
