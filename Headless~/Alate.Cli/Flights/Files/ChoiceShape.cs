using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>One of some words, or true and false.</summary>
/// <param name="words">The words; none for true and false.</param>
internal sealed class ChoiceShape(params string[] words) : FileShape
{
    public override string Words => words.Length == 0 ? "true or false" : $"one of {string.Join(", ", words)}";

    public override JsonObject Schema() => words.Length == 0
        ? new JsonObject { ["type"] = "boolean" }
        : new JsonObject { ["enum"] = new JsonArray(words.Select(word => (JsonNode)word).ToArray()) };

    public override void Check(JsonPlace value)
    {
        bool isOne = words.Length == 0
            ? value.Kind is JsonTokenType.True or JsonTokenType.False
            : value.Kind == JsonTokenType.String && words.Contains(value.Text);
        if (!isOne)
            throw Not(value);
    }
}
