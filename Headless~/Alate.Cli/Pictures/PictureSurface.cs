using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>A surface to be painted in many poses: its triangles, colours and margin.</summary>
internal sealed class PictureSurface
{
    /// <summary>A wing without colours of its own: pale membrane.</summary>
    private static readonly Color32 s_Membrane = new(206, 198, 172, 255);

    private readonly int[] m_Triangles;
    private readonly Color32[] m_Colours;
    private readonly List<(int Triangle, int A, int B)> m_Margin;
    private readonly bool m_IsThin;

    /// <param name="rest">[vertex] Rest positions; vertices at one place count as one when the margin is sought.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="colours">[vertex] or null.</param>
    /// <param name="isThin">A wing; else a closed body without a margin.</param>
    public PictureSurface(float3[] rest, int[] triangles, Color32[] colours, bool isThin)
    {
        m_Triangles = triangles;
        m_Colours = colours;
        m_IsThin = isThin;
        m_Margin = isThin ? Margin(rest, triangles) : [];
    }

    /// <summary>Hands the surface to a painter.</summary>
    /// <param name="painter">Who paints it.</param>
    /// <param name="picture">[vertex] Places on the picture, z the depth.</param>
    /// <param name="normals">[vertex] Unit normals on the body.</param>
    /// <param name="firstVertex">Where the surface's vertices begin among the picture's.</param>
    /// <param name="shading">The light.</param>
    public void Paint(Painter painter, float3[] picture, float3[] normals, int firstVertex, Shading shading)
    {
        for (int k = 0; k < m_Triangles.Length; k += 3)
        {
            int a = m_Triangles[k], b = m_Triangles[k + 1], c = m_Triangles[k + 2];
            float3 edge = picture[b] - picture[a], other = picture[c] - picture[a];
            float turn = edge.x * other.y - edge.y * other.x;
            if (turn == 0f)
                continue;
            int colour = shading.Shade(Colour(a, b, c), math.normalizesafe(normals[a] + normals[b] + normals[c]), m_IsThin);
            painter.AddTriangle(
                new PaintedShape(colour, false, turn < 0f), new int3(a, b, c) + firstVertex, picture[a], picture[b], picture[c]);
        }

        foreach ((int triangle, int a, int b) in m_Margin)
        {
            float depth = (picture[m_Triangles[triangle]].z + picture[m_Triangles[triangle + 1]].z + picture[m_Triangles[triangle + 2]].z) / 3f;
            painter.AddLine(BeatStrip.MarginLine, new int2(a, b) + firstVertex, picture[a], picture[b], depth);
        }
    }

    private float3 Colour(int a, int b, int c) =>
        m_Colours == null ? Shading.Mean(s_Membrane, s_Membrane, s_Membrane) : Shading.Mean(m_Colours[a], m_Colours[b], m_Colours[c]);

    private static List<(int Triangle, int A, int B)> Margin(float3[] rest, int[] triangles)
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

        var margin = new List<(int, int, int)>();
        for (int k = 0; k < triangles.Length; k++)
        {
            if (uses[Edge(welded, k)] == 1)
                margin.Add((k - k % 3, triangles[k], triangles[Next(k)]));
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
