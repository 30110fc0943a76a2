using System.Text.Json.Nodes;

namespace Alate.Cli;

/// <summary>An object of known keys.</summary>
/// <param name="keys">All that there are.</param>
internal sealed class ObjectShape(params FileKey[] keys) : FileShape
{
    public override string Words => "an object";

    public IReadOnlyList<FileKey> Keys => keys;

    public override JsonObject Schema()
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
            whole["required"] = new JsonArray(needed.Select(name => (JsonNode)name).ToArray());
        return whole;
    }

    public override void Check(JsonPlace value)
    {
        if (!value.IsObject)
            throw Not(value);
        foreach ((string name, JsonPlace member) in value.Members)
        {
            FileKey key = keys.FirstOrDefault(one => one.Name == name) ?? throw member.Wrong("unknown key; " + Instead(name));
            key.Shape.Check(member);
        }

        FileKey missing = keys.FirstOrDefault(key => key.IsNeeded && value[key.Name] == null);
        if (missing != null)
            throw value.Wrong($"'{missing.Name}' is missing");
    }

    // The keys that begin as it does: mostly the unit is another one.
    private string Instead(string name)
    {
        const int k_Alike = 4;
        var near = keys.Select(key => key.Name).Where(key => Alike(key, name) >= Math.Min(k_Alike, key.Length)).ToList();
        int best = near.Count == 0 ? 0 : near.Max(key => Alike(key, name));
        return near.Count > 0
            ? $"is it {string.Join(" or ", near.Where(key => Alike(key, name) == best))}?"
            : $"known: {string.Join(", ", keys.Select(key => key.Name))}";
    }

    private static int Alike(string key, string name) =>
        key.Zip(name).TakeWhile(pair => char.ToLowerInvariant(pair.First) == char.ToLowerInvariant(pair.Second)).Count();
}
