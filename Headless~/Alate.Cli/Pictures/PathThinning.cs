using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>Leaves out the points of a path that lie near the line between those kept (Douglas and Peucker 1973).</summary>
internal static class PathThinning
{
    /// <summary>Thins a path in place.</summary>
    /// <param name="points">Its points; the last of a closed one is not the first again.</param>
    /// <param name="isClosed">Whether it ends where it began.</param>
    /// <param name="slack">The farthest that a point may lie from the thinned path.</param>
    public static void Thin(List<int2> points, bool isClosed, float slack)
    {
        if (points.Count < 3)
            return;
        bool[] kept = new bool[points.Count + 1];
        if (isClosed)
        {
            points.Add(points[0]);
            int far = Farthest(points, 0, points.Count - 1).Index;
            kept[0] = kept[far] = true;
            Split(points, 0, far, slack, kept);
            Split(points, far, points.Count - 1, slack, kept);
        }
        else
        {
            kept[0] = kept[points.Count - 1] = true;
            Split(points, 0, points.Count - 1, slack, kept);
        }

        int count = 0;
        for (int k = 0; k < points.Count; k++)
        {
            if (kept[k])
                points[count++] = points[k];
        }

        points.RemoveRange(count, points.Count - count);
    }

    private static void Split(List<int2> points, int from, int to, float slack, bool[] kept)
    {
        if (to - from < 2)
            return;
        (int index, float distance) = Farthest(points, from, to);
        if (distance <= slack)
            return;
        kept[index] = true;
        Split(points, from, index, slack, kept);
        Split(points, index, to, slack, kept);
    }

    private static (int Index, float Distance) Farthest(List<int2> points, int from, int to)
    {
        float2 start = points[from], along = points[to] - points[from];
        float length = math.length(along);
        (int Index, float Distance) farthest = (from + 1, -1f);
        for (int k = from + 1; k < to; k++)
        {
            float2 offset = points[k] - start;
            float distance = length > 0f ? math.abs(along.x * offset.y - along.y * offset.x) / length : math.length(offset);
            if (distance > farthest.Distance)
                farthest = (k, distance);
        }

        return farthest;
    }
}
