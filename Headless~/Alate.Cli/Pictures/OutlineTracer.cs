using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>Turns triangles into the closed outlines of their union, and lines into the longest strokes.</summary>
internal static class OutlineTracer
{
    /// <summary>Outlines of triangles that all turn the same way; edges that two of them share vanish.</summary>
    public static List<List<int>> Outlines(List<int3> triangles)
    {
        var edges = new HashSet<long>();
        foreach (int3 triangle in triangles)
        {
            for (int k = 0; k < 3; k++)
            {
                int from = triangle[k], to = triangle[(k + 1) % 3];
                if (!edges.Remove(Key(to, from)))
                    edges.Add(Key(from, to));
            }
        }

        return Walk(edges, closed: true);
    }

    /// <summary>Strokes along lines.</summary>
    public static List<List<int>> Strokes(List<int3> lines)
    {
        var edges = new HashSet<long>();
        foreach (int3 line in lines)
            edges.Add(Key(line.x, line.y));
        return Walk(edges, closed: false);
    }

    private static List<List<int>> Walk(HashSet<long> edges, bool closed)
    {
        var next = new Dictionary<int, Stack<int>>();
        var arrivals = new HashSet<int>();
        foreach (long edge in edges)
        {
            if (!next.TryGetValue(From(edge), out Stack<int> ends))
                next.Add(From(edge), ends = new Stack<int>());
            ends.Push(To(edge));
            arrivals.Add(To(edge));
        }

        var paths = new List<List<int>>();
        var starts = new List<int>(next.Keys);
        // A stroke is walked from its beginning: where no other line arrives.
        if (!closed)
            starts.Sort((one, other) => arrivals.Contains(one).CompareTo(arrivals.Contains(other)));
        foreach (int start in starts)
        {
            while (next[start].Count > 0)
                paths.Add(WalkFrom(start, next));
        }

        return paths;
    }

    private static List<int> WalkFrom(int start, Dictionary<int, Stack<int>> next)
    {
        var path = new List<int> { start };
        int at = start;
        while (next.TryGetValue(at, out Stack<int> ends) && ends.Count > 0)
        {
            at = ends.Pop();
            path.Add(at);
            if (at == start)
                break;
        }

        return path;
    }

    private static long Key(int from, int to) => ((long)from << 32) | (uint)to;

    private static int From(long edge) => (int)(edge >> 32);

    private static int To(long edge) => (int)edge;
}
