using System.Globalization;
using Unity.Mathematics;

namespace Alate.Formats;

/// <summary>
/// Writes a scene as text of Universal Scene Description (.usda): metres, Y up, prims within one another with their attributes.
/// </summary>
internal sealed class UsdaWriter : IDisposable
{
    private const string k_Indent = "    ";

    private readonly StreamWriter m_Text;
    private int m_Depth;

    /// <summary>Begins the file.</summary>
    /// <param name="stream">Where to; stays open.</param>
    /// <param name="root">Name of the prim that stands for the file where another refers to it.</param>
    /// <param name="timeCodesPerSecond">Frames a second.</param>
    /// <param name="endTimeCode">The last frame; the first is 0.</param>
    public UsdaWriter(Stream stream, string root, double timeCodesPerSecond, double endTimeCode)
    {
        m_Text = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        m_Text.WriteLine("#usda 1.0");
        m_Text.WriteLine("(");
        m_Text.WriteLine($"{k_Indent}defaultPrim = \"{root}\"");
        m_Text.WriteLine($"{k_Indent}endTimeCode = {Number(endTimeCode)}");
        m_Text.WriteLine($"{k_Indent}framesPerSecond = {Number(timeCodesPerSecond)}");
        m_Text.WriteLine($"{k_Indent}metersPerUnit = 1");
        m_Text.WriteLine($"{k_Indent}startTimeCode = 0");
        m_Text.WriteLine($"{k_Indent}timeCodesPerSecond = {Number(timeCodesPerSecond)}");
        m_Text.WriteLine($"{k_Indent}upAxis = \"Y\"");
        m_Text.WriteLine(")");
    }

    /// <summary>A name that a prim may have: letters, digits and underscores, no digit first.</summary>
    public static string Name(string text)
    {
        string name = string.Concat(text.Select(letter => char.IsAsciiLetterOrDigit(letter) ? letter : '_'));
        return name.Length == 0 || char.IsAsciiDigit(name[0]) ? "_" + name : name;
    }

    /// <summary>A name as <see cref="Name"/> makes them that is not among the used ones, and is from now on.</summary>
    public static string Unused(string text, HashSet<string> used)
    {
        string name = Name(text), free = name;
        for (int k = 2; !used.Add(free); k++)
            free = $"{name}_{k}";
        return free;
    }

    /// <summary>A number in up to 15 digits.</summary>
    public static string Number(double value) => value.ToString("G15", CultureInfo.InvariantCulture);

    /// <summary>A number in up to eight digits.</summary>
    public static string Number(float value) => value.ToString("G8", CultureInfo.InvariantCulture);

    /// <summary>A text or token.</summary>
    public static string Text(string text) => $"\"{text.Replace("\\", "\\\\").Replace("\"", "\\\"")}\"";

    public static string Tuple(float2 value) => $"({Number(value.x)}, {Number(value.y)})";

    public static string Tuple(float3 value) => $"({Number(value.x)}, {Number(value.y)}, {Number(value.z)})";

    /// <summary>A rotation, its real part first.</summary>
    public static string Tuple(quaternion value) => $"({Number(value.value.w)}, {Tuple(value.value.xyz)[1..]}";

    /// <summary>A matrix that moves; rows, and what it moves by in the last.</summary>
    public static string Translation(float3 by) => $"((1, 0, 0, 0), (0, 1, 0, 0), (0, 0, 1, 0), {Tuple(by)[..^1]}, 1))";

    public static string List<T>(IEnumerable<T> values, Func<T, string> write) => $"[{string.Join(", ", values.Select(write))}]";

    /// <summary>Begins a prim within the one that is open.</summary>
    /// <param name="type">Its schema.</param>
    /// <param name="name">A name as <see cref="Name"/> makes them.</param>
    /// <param name="schemas">Schemas that are applied to it.</param>
    public void Begin(string type, string name, params string[] schemas)
    {
        m_Text.WriteLine();
        Line($"def {type} {Text(name)}", schemas.Length == 0 ? [] : [$"prepend apiSchemas = {List(schemas, Text)}"]);
        Line("{");
        m_Depth++;
    }

    /// <summary>Ends the prim that is open.</summary>
    public void End()
    {
        m_Depth--;
        Line("}");
    }

    /// <summary>An attribute, a connection or a relationship.</summary>
    /// <param name="declared">Its type and name.</param>
    /// <param name="value">Its value.</param>
    /// <param name="metadata">What is said of it.</param>
    public void Set(string declared, string value, params string[] metadata) => Line($"{declared} = {value}", metadata);

    /// <summary>An attribute that others connect to.</summary>
    public void Declare(string declared) => Line(declared);

    /// <summary>An attribute over time.</summary>
    public void Samples(string declared, IEnumerable<(double Time, string Value)> samples)
    {
        Line(declared + ".timeSamples = {");
        m_Depth++;
        foreach ((double time, string value) in samples)
            Line($"{Number(time)}: {value},");
        End();
    }

    public void Dispose() => m_Text.Dispose();

    // Each piece of metadata stands on a line of its own, as the grammar wants.
    private void Line(string text, string[] metadata)
    {
        Line(metadata.Length == 0 ? text : text + " (");
        if (metadata.Length == 0)
            return;
        m_Depth++;
        foreach (string piece in metadata)
            Line(piece);
        m_Depth--;
        Line(")");
    }

    private void Line(string text)
    {
        for (int k = 0; k < m_Depth; k++)
            m_Text.Write(k_Indent);
        m_Text.WriteLine(text);
    }
}
