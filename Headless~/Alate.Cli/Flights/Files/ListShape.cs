using System.Text.Json;
using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>A list of values of one kind.</summary>
/// <param name="item">Each of them.</param>
/// <param name="least">The fewest.</param>
/// <param name="most">The most.</param>
/// <param name="words">What it is.</param>
internal sealed class ListShape(FileShape item, int least, int most, string words) : FileShape
{
    public override string Words => words;

    public override IEnumerable<FileShape> Inner => [item];

    public override JsonObject Schema() => new()
    {
        ["type"] = "array",
        ["items"] = item.Schema(),
        ["minItems"] = least,
        ["maxItems"] = most,
    };

    public override void Check(JsonPlace value)
    {
        if (value.Kind != JsonTokenType.StartArray)
            throw Not(value);
        if (value.Items.Count < least || value.Items.Count > most)
            throw value.Wrong($"it must be {Words}, not {value.Items.Count} values");
        foreach (JsonPlace one in value.Items)
            item.Check(one);
    }
}
