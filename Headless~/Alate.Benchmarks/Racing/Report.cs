using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;

namespace Alate.Benchmarks;

/// <summary>Prints what was measured as it comes and keeps it for the JSON.</summary>
internal sealed class Report
{
    private const string k_Columns = "{0,-58} {1,10} {2,12} {3,9} {4,7} {5,7}  {6}";

    private readonly TextWriter m_Output;

    public Report(TextWriter output) => m_Output = output;

    /// <summary>Content of the JSON, in order: numbers, texts, and dictionaries of them.</summary>
    public Dictionary<string, object> Content { get; } = [];

    /// <summary>True where every baseline gave a result equal to ours.</summary>
    public bool IsValid { get; private set; } = true;

    public void Heading() => Row("", "ours", "baseline", "ratio", "must", "aim", "");

    /// <summary>A baseline counts only if it computes the same.</summary>
    public void Check(string statement, double difference, double tolerance)
    {
        if (difference <= tolerance)
            return;
        IsValid = false;
        m_Output.WriteLine(Format($"INVALID: {statement}: differs by {difference:G3}, allowed {tolerance:G3}."));
    }

    /// <summary>A ratio with its two times.</summary>
    public void Ratio(Target target, double ours, double baseline, double ratio)
    {
        Content[target.Key] = ratio;
        Absolute(target.Key + "_ours", target.Unit, ours);
        Absolute(target.Key + "_baseline", target.Unit, baseline);
        Row($"{target.Title}, {target.Unit}", Number(ours), Number(baseline), Number(ratio), Bound(target, target.Must),
            Bound(target, target.Aim), target.Verdict(ratio));
    }

    /// <summary>A ratio for each of several things, with its two times. The group names the thing.</summary>
    public void Ratio(Target target, string group, double ours, double baseline, double ratio)
    {
        Group(target.Key)[group] = ratio;
        Group(target.Key + "_ours_us_insect")[group] = ours;
        Group(target.Key + "_baseline_us_insect")[group] = baseline;
        Row($"{group}: {target.Title}, {target.Unit}", Number(ours), Number(baseline), Number(ratio), Bound(target, target.Must),
            Bound(target, target.Aim), target.Verdict(ratio));
    }

    /// <summary>One figure that has a target by itself.</summary>
    public void Bounded(Target target, double value)
    {
        Content[target.Key] = value;
        Row($"{target.Title}, {target.Unit}", Number(value), "", "", Bound(target, target.Must), Bound(target, target.Aim),
            target.Verdict(value));
    }

    /// <summary>One figure that no target goes with.</summary>
    public void Figure(string key, string title, string unit, double value)
    {
        Content[key] = value;
        Row($"{title}, {unit}", Number(value), "", "", "", "", "");
    }

    /// <summary>One figure for each of several things: species, crowd sizes. The title names the thing.</summary>
    public void Figure(string key, string group, string title, string unit, double value)
    {
        Group(key)[group] = value;
        Row($"{title}, {unit}", Number(value), "", "", "", "", "");
    }

    public void Line(string text) => m_Output.WriteLine(text);

    private void Absolute(string name, string unit, double value) => Group("times")[$"{name}_{unit.Replace('/', '_')}"] = value;

    private Dictionary<string, object> Group(string key)
    {
        if (!Content.TryGetValue(key, out object group))
            Content[key] = group = new Dictionary<string, object>();
        return (Dictionary<string, object>)group;
    }

    private void Row(params object[] cells) =>
        m_Output.WriteLine(string.Format(CultureInfo.InvariantCulture, k_Columns, cells).TrimEnd());

    private static string Bound(Target target, double value) => (target.LargerIsBetter ? ">= " : "<= ") + Format($"{value:0.##}");

    private static string Number(double value) =>
        value == Math.Round(value) && value < 1e5 ? Format($"{value:0}") : Format($"{value:0.00}");

    private static string Format(FormattableString text) => text.ToString(CultureInfo.InvariantCulture);
}
