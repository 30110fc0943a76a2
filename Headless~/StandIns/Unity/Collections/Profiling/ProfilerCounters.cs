using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Unity.StandIns;

/// <summary>The values of counters, as of the end of the last frame.</summary>
internal static unsafe class ProfilerCounters
{
    private static readonly Dictionary<(ushort Category, string Name), Counter> s_Counters = [];

    private sealed class Counter
    {
        public readonly int* Value = (int*)NativeMemory.AllocZeroed(sizeof(int));

        public int Last;
    }

    /// <summary>Counters last as long as the process; one that is made again is the same.</summary>
    public static int* Add(ushort category, string name, out IntPtr counter)
    {
        if (!s_Counters.TryGetValue((category, name), out Counter found))
            s_Counters.Add((category, name), found = new Counter());
        counter = (IntPtr)found.Value;
        return found.Value;
    }

    public static bool Has(ushort category, string name) => s_Counters.ContainsKey((category, name));

    public static int Last(ushort category, string name) => s_Counters[(category, name)].Last;

    public static void EndFrame()
    {
        foreach (Counter counter in s_Counters.Values)
            counter.Last = *counter.Value;
    }
}
