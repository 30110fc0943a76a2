using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Flights;

/// <summary>Stretch of the membrane around each vertex of a wing: the largest |l/l₀ − 1| of the edges that meet there.</summary>
internal sealed class StretchField
{
    private readonly (int A, int B, float Length)[] m_Edges;
    private readonly float[] m_Values;

    public StretchField(RecordedWing wing)
    {
        var edges = new Dictionary<(int, int), float>();
        for (int corner = 0; corner < wing.Triangles.Length; corner++)
        {
            int a = wing.Triangles[corner], b = wing.Triangles[corner % 3 == 2 ? corner - 2 : corner + 1];
            float length = math.distance(wing.Rest[a], wing.Rest[b]);
            if (length > 0f)
                edges[(Math.Min(a, b), Math.Max(a, b))] = length;
        }

        m_Edges = new (int, int, float)[edges.Count];
        int count = 0;
        foreach (((int a, int b), float length) in edges)
            m_Edges[count++] = (a, b, length);
        m_Values = new float[wing.Rest.Length];
    }

    /// <summary>[vertex] Of a shape; the next call overwrites them.</summary>
    /// <param name="positions">[vertex] Wing lengths.</param>
    public float[] Of(float3[] positions)
    {
        Array.Clear(m_Values);
        foreach ((int a, int b, float length) in m_Edges)
        {
            float stretch = math.abs(math.distance(positions[a], positions[b]) / length - 1f);
            m_Values[a] = math.max(m_Values[a], stretch);
            m_Values[b] = math.max(m_Values[b], stretch);
        }

        return m_Values;
    }

    /// <summary>[vertex] Largest over the recorded beat.</summary>
    public static float[] Largest(RecordedWing wing)
    {
        var field = new StretchField(wing);
        float[] largest = new float[wing.Rest.Length];
        foreach (RecordedFrame frame in wing.Frames)
        {
            float[] values = field.Of(frame.Positions);
            for (int k = 0; k < largest.Length; k++)
                largest[k] = math.max(largest[k], values[k]);
        }

        return largest;
    }
}
