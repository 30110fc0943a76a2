using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>An object whose keys are names of the user's.</summary>
/// <param name="item">The value of each.</param>
/// <param name="name">What a name must be.</param>
/// <param name="words">What it is.</param>
internal sealed class MapShape(FileShape item, TextShape name, string words) : FileShape
{
    private const int k_Most = 4;

    public override string Words => words;

    public override IEnumerable<FileShape> Inner => [item];

    public override JsonObject Schema() => new()
    {
        ["type"] = "object",
        ["propertyNames"] = name.Schema(),
        ["additionalProperties"] = item.Schema(),
        ["minProperties"] = 1,
        ["maxProperties"] = k_Most,
    };

    public override void Check(JsonPlace value)
    {
        if (!value.IsObject || value.Members.Count is 0 or > k_Most)
            throw Not(value);
        foreach ((string key, JsonPlace member) in value.Members)
        {
            name.Check(member.Named(key));
            item.Check(member);
        }
    }
}
