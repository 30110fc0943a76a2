using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using Unity.Mathematics;

namespace Alate.Tests.Bakes;

/// <summary>Prims and attributes of a USD file in text, one attribute or sample a line.</summary>
internal sealed class UsdaFile
{
    private static readonly Regex s_Prim = new(@"^\s*def (\w+) ""(\w+)""( \($)?"), s_Value = new(@"^\s*(.+?) = (.*)$"),
        s_Sample = new(@"^\s*([-\d.E+]+): (.*),$"), s_Number = new(@"-?\d[\d.]*(E[-+]?\d+)?");

    private readonly Dictionary<string, string> m_Types = [];
    private readonly Dictionary<string, string> m_Values = [];
    private readonly Dictionary<string, List<(double Time, string Value)>> m_Samples = [];

    public UsdaFile(string path)
    {
        List<string> open = [];
        List<(double, string)> samples = null;
        foreach (string line in File.ReadLines(path).Skip(1))
        {
            if (s_Prim.Match(line) is { Success: true } prim)
            {
                open.Add(prim.Groups[2].Value);
                m_Types.Add("/" + string.Join('/', open), prim.Groups[1].Value);
            }
            else if (line.TrimEnd().EndsWith(".timeSamples = {"))
            {
                m_Samples.Add(Place(open, line.Split(".timeSamples")[0]), samples = []);
            }
            else if (line.Trim() == "}" && samples != null)
            {
                samples = null;
            }
            else if (line.Trim() == "}")
            {
                open.RemoveAt(open.Count - 1);
            }
            else if (samples != null && s_Sample.Match(line) is { Success: true } sample)
            {
                samples.Add((double.Parse(sample.Groups[1].Value, CultureInfo.InvariantCulture), sample.Groups[2].Value));
            }
            else if (s_Value.Match(line) is { Success: true } value)
            {
                m_Values.TryAdd(Place(open, value.Groups[1].Value), value.Groups[2].Value);
            }
            else if (line.Contains("outputs:"))
            {
                m_Values.Add(Place(open, line), null);
            }
        }

        if (open.Count > 0)
            throw new InvalidDataException($"/{string.Join('/', open)} has no end.");
    }

    /// <summary>Paths of the prims of a type, in their order.</summary>
    public string[] Of(string type) => [.. m_Types.Where(prim => prim.Value == type).Select(prim => prim.Key)];

    /// <summary>Values of connections and relationships: paths of prims or of their attributes.</summary>
    public IEnumerable<string> Targets => m_Values.Values.Where(value => value?.StartsWith("</") == true).Select(value => value[1..^1]);

    /// <summary>True for the path of a prim or of an attribute.</summary>
    public bool Has(string path) => m_Types.ContainsKey(path) || m_Values.ContainsKey(path);

    /// <summary>An attribute as it is written; null where there is none.</summary>
    public string Text(string path) => m_Values.GetValueOrDefault(path);

    /// <summary>Its numbers one after the other.</summary>
    public float[] Numbers(string path) => Parse(m_Values[path]);

    /// <summary>Its numbers three by three.</summary>
    public float3[] Vectors(string path) => [.. Numbers(path).Chunk(3).Select(three => new float3(three[0], three[1], three[2]))];

    /// <summary>Its words.</summary>
    public string[] Words(string path) => [.. Regex.Matches(m_Values[path], @"""([^""]*)""").Select(word => word.Groups[1].Value)];

    /// <summary>Numbers of an attribute at each of its times.</summary>
    public (double Time, float[] Numbers)[] Samples(string path) =>
        [.. m_Samples[path].Select(sample => (sample.Time, Parse(sample.Value)))];

    private static float[] Parse(string text) =>
        [.. s_Number.Matches(text).Select(number => float.Parse(number.Value, CultureInfo.InvariantCulture))];

    // "/prim.name": without type and variability. Metadata of the file has no prim.
    private static string Place(List<string> open, string declared) => $"/{string.Join('/', open)}.{declared.Trim().Split(' ')[^1]}";
}
