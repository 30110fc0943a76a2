using System.Text.Json;

namespace Alate.Cli;

/// <summary>A value of a JSON file with its place in it, for messages.</summary>
internal sealed class JsonPlace
{
    private const int k_Depth = 32;

    /// <summary>Kind of the value: an object or a list by its first token.</summary>
    public JsonTokenType Kind { get; private init; }

    /// <summary>Keys from the root, such as <c>wings.fore wing.beat</c>; empty at the root.</summary>
    public string Path { get; private init; }

    /// <summary>Line of the file, from 1.</summary>
    public int Line { get; private init; }

    /// <summary>A text, or a number as it is written.</summary>
    public string Text { get; private init; }

    /// <summary>Members of an object in the file's order, each name once.</summary>
    public IReadOnlyList<(string Key, JsonPlace Value)> Members { get; private init; } = [];

    /// <summary>Values of a list.</summary>
    public IReadOnlyList<JsonPlace> Items { get; private init; } = [];

    /// <summary>Returns true for an object.</summary>
    public bool IsObject => Kind == JsonTokenType.StartObject;

    /// <summary>The member of an object, null where it has none.</summary>
    public JsonPlace this[string key] => Members.FirstOrDefault(member => member.Key == key).Value;

    /// <summary>Reads a whole file.</summary>
    /// <exception cref="FormatException">It is no JSON, or a key stands in an object twice.</exception>
    public static JsonPlace Read(TextReader text)
    {
        byte[] bytes = Encoding.UTF8.GetBytes(text.ReadToEnd());
        var reader = new Utf8JsonReader(bytes, new JsonReaderOptions { MaxDepth = k_Depth });
        try
        {
            reader.Read();
            JsonPlace root = Value(ref reader, bytes, "");
            reader.Read();
            return root;
        }
        catch (JsonException problem)
        {
            throw new FormatException($"line {problem.LineNumber + 1}: not JSON at column {problem.BytePositionInLine + 1}.");
        }
    }

    /// <summary>Problem of this value, with its line and path.</summary>
    public FormatException Wrong(string problem) =>
        new($"line {Line}{(Path.Length == 0 ? "" : $", {Path}")}: {problem}{(problem.EndsWith('?') ? "" : ".")}");

    /// <summary>The value as a message shows it.</summary>
    public string Shown => Kind switch
    {
        JsonTokenType.StartObject => "an object",
        JsonTokenType.StartArray => "a list",
        JsonTokenType.String => Quote.Of(Text),
        _ => Text,
    };

    /// <summary>A text at this place: the key of this value, to be checked.</summary>
    public JsonPlace Named(string key) => new() { Kind = JsonTokenType.String, Path = Path, Line = Line, Text = key };

    private static JsonPlace Value(ref Utf8JsonReader reader, byte[] bytes, string path)
    {
        JsonTokenType kind = reader.TokenType;
        int line = 1 + bytes.AsSpan(0, (int)reader.TokenStartIndex).Count((byte)'\n');
        string text = kind is JsonTokenType.StartObject or JsonTokenType.StartArray ? null
            : kind == JsonTokenType.String ? Unescaped(ref reader, line, path) : Encoding.UTF8.GetString(reader.ValueSpan);
        var members = new List<(string, JsonPlace)>();
        var items = new List<JsonPlace>();
        if (kind == JsonTokenType.StartObject)
        {
            var seen = new HashSet<string>();
            while (reader.Read() && reader.TokenType != JsonTokenType.EndObject)
            {
                string key = Unescaped(ref reader, line, path), place = path.Length == 0 ? Short(key) : $"{path}.{Short(key)}";
                int at = 1 + bytes.AsSpan(0, (int)reader.TokenStartIndex).Count((byte)'\n');
                if (!seen.Add(key))
                    throw new FormatException($"line {at}, {place}: the key stands there twice.");
                reader.Read();
                members.Add((key, Value(ref reader, bytes, place)));
            }
        }
        else if (kind == JsonTokenType.StartArray)
        {
            while (reader.Read() && reader.TokenType != JsonTokenType.EndArray)
                items.Add(Value(ref reader, bytes, $"{path}[{items.Count}]"));
        }

        return new JsonPlace { Kind = kind, Path = path, Line = line, Text = text, Members = members, Items = items };
    }

    private static string Short(string key)
    {
        string quoted = Quote.Of(string.Concat(key.Select(letter => char.IsControl(letter) ? ' ' : letter)));
        return quoted[1..^1];
    }

    // Half a character, written as an escape, is no text.
    private static string Unescaped(ref Utf8JsonReader reader, int line, string path)
    {
        try
        {
            return reader.GetString();
        }
        catch (InvalidOperationException)
        {
            throw new FormatException(path.Length == 0 ? $"line {line}: a text is no Unicode." : $"line {line}, {path}: it is no Unicode.");
        }
    }
}
