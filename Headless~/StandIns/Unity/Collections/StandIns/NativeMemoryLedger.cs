using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using Unity.Collections;
using Unity.StandIns;

namespace StandIns;

/// <summary>All native memory that is allocated and not yet freed, for tests that assert that nothing leaks.</summary>
[StandInExtension]
public static class NativeMemoryLedger
{
    internal struct Entry
    {
        public long size;
        public Allocator allocator;
        public Type type;
        public string trace;
        public ContainerSafety safety;
        public bool isTracked;

        public readonly string Source =>
            type != null ? $"NativeArray<{type.Name}>" : isTracked ? "UnsafeUtility.MallocTracked" : "UnsafeUtility.Malloc";
    }

    private static readonly object s_Gate = new();
    private static readonly Dictionary<nint, Entry> s_Lasting = [];
    private static readonly Dictionary<nint, Entry> s_Temporary = [];

    /// <summary>Live allocations of Allocator.Persistent and Allocator.TempJob.</summary>
    public static int LiveCount
    {
        get
        {
            lock (s_Gate)
                return s_Lasting.Count;
        }
    }

    /// <summary>Number of the allocations that Unity's leak detection would not see.</summary>
    public static int UntrackedCount
    {
        get
        {
            lock (s_Gate)
                return s_Lasting.Values.Count(entry => !entry.isTracked);
        }
    }

    /// <summary>Bytes in those allocations.</summary>
    public static long LiveBytes
    {
        get
        {
            long bytes = 0;
            lock (s_Gate)
            {
                foreach (Entry entry in s_Lasting.Values)
                    bytes += entry.size;
            }

            return bytes;
        }
    }

    /// <summary>[source] Bytes in those allocations, such as "NativeArray&lt;Single&gt;".</summary>
    public static IReadOnlyDictionary<string, long> BytesBySource()
    {
        lock (s_Gate)
        {
            return s_Lasting.Values.GroupBy(entry => entry.Source)
                .ToDictionary(source => source.Key, source => source.Sum(entry => entry.size));
        }
    }

    /// <summary>One line for each live allocation; empty if there is none.</summary>
    public static string Describe()
    {
        var text = new StringBuilder();
        lock (s_Gate)
        {
            foreach (Entry entry in s_Lasting.Values)
            {
                text.Append(CultureInfo.InvariantCulture, $"{entry.Source}, {entry.size} bytes, Allocator.{entry.allocator}").AppendLine();
                if (entry.trace != null)
                    text.AppendLine(entry.trace);
            }
        }

        return text.ToString();
    }

    /// <summary>Frees what was allocated with Allocator.Temp and not disposed, as Unity does at the end of each frame.</summary>
    public static unsafe void EndFrame()
    {
        KeyValuePair<nint, Entry>[] temporary;
        lock (s_Gate)
        {
            if (s_Temporary.Count == 0)
                return;
            temporary = [.. s_Temporary];
            s_Temporary.Clear();
        }

        foreach ((nint address, Entry entry) in temporary)
        {
            entry.safety?.Release();
            NativeHeap.Release((void*)address, entry.size);
        }
    }

    internal static void Add(nint address, in Entry entry)
    {
        lock (s_Gate)
            (entry.allocator == Allocator.Temp ? s_Temporary : s_Lasting).Add(address, entry);
    }

    internal static Entry? Find(nint address)
    {
        lock (s_Gate)
            return s_Lasting.TryGetValue(address, out Entry entry) || s_Temporary.TryGetValue(address, out entry) ? entry : null;
    }

    internal static bool Remove(nint address, out Entry entry)
    {
        lock (s_Gate)
            return s_Lasting.Remove(address, out entry) || s_Temporary.Remove(address, out entry);
    }
}
