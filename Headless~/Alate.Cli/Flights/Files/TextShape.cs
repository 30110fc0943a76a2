using System.Text.Json;
using System.Text.Json.Nodes;
using System.Text.RegularExpressions;

namespace Alate.Cli;

/// <summary>A text.</summary>
/// <param name="words">What it says.</param>
/// <param name="pattern">Regular expression of the whole text; null for any.</param>
/// <param name="most">Most characters.</param>
internal sealed class TextShape(string words, int most = 500, string pattern = null) : FileShape
{
    public override string Words => words;

    public override JsonObject Schema()
    {
        var schema = new JsonObject { ["type"] = "string", ["minLength"] = 1, ["maxLength"] = most };
        if (pattern != null)
            schema["pattern"] = pattern;
        return schema;
    }

    public override void Check(JsonPlace value)
    {
        if (value.Kind != JsonTokenType.String || string.IsNullOrWhiteSpace(value.Text) || value.Text.Length > most
            || value.Text.Any(char.IsControl) || pattern != null && !Regex.IsMatch(value.Text, pattern))
        {
            throw Not(value);
        }
    }
}
