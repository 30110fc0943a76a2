using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>The edges around a mesh.</summary>
internal static class MeshMargin
{
    /// <summary>Every edge that belongs to one triangle only.</summary>
    /// <param name="rest">[vertex] Rest positions; vertices at one place count as one.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    public static List<MarginEdge> Of(float3[] rest, int[] triangles)
    {
        var places = new Dictionary<float3, int>();
        int[] welded = Array.ConvertAll(triangles, vertex =>
        {
            places.TryAdd(rest[vertex], vertex);
            return places[rest[vertex]];
        });
        var uses = new Dictionary<(int, int), int>();
        for (int k = 0; k < triangles.Length; k++)
        {
            (int, int) key = Edge(welded, k);
            uses[key] = uses.GetValueOrDefault(key) + 1;
        }

        var margin = new List<MarginEdge>();
        for (int k = 0; k < triangles.Length; k++)
        {
            if (uses[Edge(welded, k)] == 1)
                margin.Add(new MarginEdge(k / 3, triangles[k], triangles[Next(k)]));
        }

        return margin;
    }

    private static (int, int) Edge(int[] welded, int corner)
    {
        int a = welded[corner], b = welded[Next(corner)];
        return (Math.Min(a, b), Math.Max(a, b));
    }

    private static int Next(int corner) => corner % 3 == 2 ? corner - 2 : corner + 1;
}
