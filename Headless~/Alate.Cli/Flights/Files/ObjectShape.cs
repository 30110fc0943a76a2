using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>An object of known keys.</summary>
/// <param name="name">Name of this kind in the schema and the manual.</param>
/// <param name="keys">All that there are.</param>
internal sealed class ObjectShape(string name, params FileKey[] keys) : FileShape
{
    /// <summary>Name of this kind in the schema and the manual.</summary>
    public string Name => name;

    public override string Words => "an object";

    public IReadOnlyList<FileKey> Keys => keys;

    public override IEnumerable<FileShape> Inner => keys.Select(key => key.Shape);

    public override JsonObject Schema() => new() { ["$ref"] = "#/$defs/" + name };

    /// <summary>The schema behind the name.</summary>
    public JsonObject Definition()
    {
        var properties = new JsonObject();
        foreach (FileKey key in keys)
        {
            JsonObject schema = key.Shape.Schema();
            schema.Insert(0, "description", key.Help);
            properties[key.Name] = schema;
        }

        var whole = new JsonObject { ["type"] = "object", ["properties"] = properties, ["additionalProperties"] = false };
        string[] needed = keys.Where(key => key.IsNeeded).Select(key => key.Name).ToArray();
        if (needed.Length > 0)
            whole["required"] = new JsonArray(needed.Select(key => (JsonNode)key).ToArray());
        return whole;
    }

    public override void Check(JsonPlace value)
    {
        if (!value.IsObject)
            throw Not(value);
        foreach ((string one, JsonPlace member) in value.Members)
        {
            FileKey key = keys.FirstOrDefault(known => known.Name == one) ?? throw member.Wrong("unknown key; " + Instead(one));
            key.Shape.Check(member);
        }

        FileKey missing = keys.FirstOrDefault(key => key.IsNeeded && value[key.Name] == null);
        if (missing != null)
            throw value.Wrong($"'{missing.Name}' is missing");
    }

    // The keys that begin as it does: mostly the unit is another one.
    private string Instead(string typed)
    {
        const int k_Alike = 4;
        var near = keys.Select(key => key.Name).Where(key => Alike(key, typed) >= Math.Min(k_Alike, key.Length)).ToList();
        int best = near.Count == 0 ? 0 : near.Max(key => Alike(key, typed));
        return near.Count > 0
            ? $"is it {string.Join(" or ", near.Where(key => Alike(key, typed) == best))}?"
            : $"known: {string.Join(", ", keys.Select(key => key.Name))}";
    }

    private static int Alike(string key, string name) =>
        key.Zip(name).TakeWhile(pair => char.ToLowerInvariant(pair.First) == char.ToLowerInvariant(pair.Second)).Count();
}
