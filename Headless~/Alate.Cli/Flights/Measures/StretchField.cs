namespace Alate.Cli;

/// <summary>Stretch of the membrane around each vertex of a wing: the largest |l/l₀ − 1| of the edges that meet there.</summary>
internal sealed class StretchField
{
    private readonly EdgeStretch m_Edges;
    private readonly float[] m_Stretches;
    private readonly float[] m_Values;

    public StretchField(RecordedWing wing)
    {
        m_Edges = new EdgeStretch(wing.Rest, wing.Triangles);
        m_Stretches = new float[m_Edges.Count];
        m_Values = new float[wing.Rest.Length];
    }

    /// <summary>[vertex] Of a shape; the next call overwrites them.</summary>
    /// <param name="positions">[vertex] Wing lengths.</param>
    public float[] Of(float3[] positions)
    {
        Array.Clear(m_Values);
        m_Edges.Measure(positions, m_Stretches);
        for (int k = 0; k < m_Edges.Count; k++)
        {
            (int a, int b) = m_Edges[k];
            m_Values[a] = math.max(m_Values[a], m_Stretches[k]);
            m_Values[b] = math.max(m_Values[b], m_Stretches[k]);
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
