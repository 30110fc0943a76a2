using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>A mesh with every triangle parted into four at the middles of its edges, so that colours are painted finer than the mesh.</summary>
internal sealed class FineTriangles
{
    private readonly List<int2> m_Edges = [];
    private readonly int m_CoarseVertices;

    public FineTriangles(int vertexCount, int[] triangles)
    {
        m_CoarseVertices = vertexCount;
        var middles = new Dictionary<long, int>();
        for (int k = 0; k < triangles.Length; k += 3)
        {
            int a = triangles[k], b = triangles[k + 1], c = triangles[k + 2];
            int ab = Middle(a, b, middles), bc = Middle(b, c, middles), ca = Middle(c, a, middles);
            Triangles.Add(new int3(a, ab, ca));
            Triangles.Add(new int3(ab, b, bc));
            Triangles.Add(new int3(ca, bc, c));
            Triangles.Add(new int3(ab, bc, ca));
        }
    }

    /// <summary>Four in a row for each triangle of the mesh: its three corners, then its middle.</summary>
    public List<int3> Triangles { get; } = [];

    /// <summary>[fine vertex] Values at the mesh's vertices, and at the middles of its edges.</summary>
    public float3[] Refine(float3[] values)
    {
        var fine = new float3[m_CoarseVertices + m_Edges.Count];
        values.CopyTo(fine, 0);
        for (int k = 0; k < m_Edges.Count; k++)
            fine[m_CoarseVertices + k] = 0.5f * (values[m_Edges[k].x] + values[m_Edges[k].y]);
        return fine;
    }

    /// <summary>The mesh's vertices that a fine vertex lies between.</summary>
    public int2 Ends(int vertex) => vertex < m_CoarseVertices ? vertex : m_Edges[vertex - m_CoarseVertices];

    private int Middle(int a, int b, Dictionary<long, int> middles)
    {
        long key = ((long)math.min(a, b) << 32) | (uint)math.max(a, b);
        if (middles.TryGetValue(key, out int middle))
            return middle;
        middles.Add(key, m_CoarseVertices + m_Edges.Count);
        m_Edges.Add(new int2(a, b));
        return middles[key];
    }
}
