using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;

namespace Unity.StandIns;

/// <summary>Times for which each profiler marker was open, on the main thread, without the time of markers within it.</summary>
[StandInExtension]
public static class MarkerTimes
{
    private static readonly List<string> s_Names = [];
    private static readonly List<long> s_Ticks = [];
    private static readonly Stack<int> s_Open = new();
    private static long s_Since;

    /// <summary>True while times are recorded.</summary>
    public static bool On { get; set; }

    /// <summary>Seconds by name since the last <see cref="Clear"/>.</summary>
    public static IReadOnlyDictionary<string, double> Seconds() =>
        s_Names.Select((name, k) => (name, s_Ticks[k])).ToDictionary(p => p.name, p => p.Item2 / (double)Stopwatch.Frequency);

    /// <summary>Starts from zero.</summary>
    public static void Clear()
    {
        for (int k = 0; k < s_Ticks.Count; k++)
            s_Ticks[k] = 0;
    }

    internal static int IndexOf(string name)
    {
        int index = s_Names.IndexOf(name);
        if (index >= 0)
            return index;
        s_Names.Add(name);
        s_Ticks.Add(0);
        return s_Names.Count - 1;
    }

    internal static void Begin(int index)
    {
        if (!On)
            return;
        long now = Stopwatch.GetTimestamp();
        if (s_Open.TryPeek(out int outer))
            s_Ticks[outer] += now - s_Since;
        s_Open.Push(index);
        s_Since = now;
    }

    internal static void End(int index)
    {
        if (!On || !s_Open.TryPop(out int open))
            return;
        long now = Stopwatch.GetTimestamp();
        s_Ticks[open] += now - s_Since;
        s_Since = now;
    }
}
