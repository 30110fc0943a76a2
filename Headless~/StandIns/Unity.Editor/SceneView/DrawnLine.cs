using System;
using StandIns;
using UnityEngine;

namespace UnityEditor;

/// <summary>A line that would be drawn.</summary>
internal static class DrawnLine
{
    /// <summary>Points must be finite, and as many as are asked for.</summary>
    public static void Check(Vector3[] points, int count, float? width = null)
    {
        foreach (Vector3 point in points.AsSpan(0, count))
        {
            if (!float.IsFinite(point.x + point.y + point.z))
                throw new ArgumentException($"A line through {point} cannot be drawn.");
        }

        DrawnLines.Calls?.Add((Handles.color, points[..count]));
        if (width.HasValue)
            DrawnLines.Widths?.Add(width.Value);
    }
}
