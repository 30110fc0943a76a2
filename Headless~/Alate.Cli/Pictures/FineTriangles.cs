using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>
/// A mesh with every triangle parted into four at the middles of its edges, once or until there are enough, so that colours and depths are
/// finer than the mesh.
/// </summary>
internal sealed class FineTriangles
{
    private readonly List<List<int2>> m_Middles = [];

    /// <param name="vertexCount">Vertices of the mesh.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="least">Part the triangles until there are at least so many; once in any case.</param>
    public FineTriangles(int vertexCount, int[] triangles, int least)
    {
        for (int k = 0; k < triangles.Length; k += 3)
            Triangles.Add(new int3(triangles[k], triangles[k + 1], triangles[k + 2]));
        do
        {
            Parents = Triangles;
            Triangles = Part(Parents, vertexCount);
            vertexCount += m_Middles[^1].Count;
        }
        while (Triangles.Count > 0 && Triangles.Count < least);
    }

    /// <summary>The triangles; four in a row are the parts of one parent.</summary>
    public List<int3> Triangles { get; private set; } = [];

    /// <summary>Triangles that were divided last.</summary>
    public List<int3> Parents { get; private set; }

    /// <summary>[fine vertex] Values at the mesh's vertices, and half-way between them at the others.</summary>
    public float3[] Refine(float3[] values)
    {
        var fine = new List<float3>(values);
        foreach (List<int2> middles in m_Middles)
        {
            foreach (int2 ends in middles)
                fine.Add(0.5f * (fine[ends.x] + fine[ends.y]));
        }

        return fine.ToArray();
    }

    private List<int3> Part(List<int3> triangles, int vertexCount)
    {
        var parts = new List<int3>();
        var middles = new List<int2>();
        var known = new Dictionary<int2, int>();
        foreach (int3 triangle in triangles)
        {
            int3 half = new(Middle(triangle.x, triangle.y), Middle(triangle.y, triangle.z), Middle(triangle.z, triangle.x));
            parts.Add(new int3(triangle.x, half.x, half.z));
            parts.Add(new int3(half.x, triangle.y, half.y));
            parts.Add(new int3(half.z, half.y, triangle.z));
            parts.Add(half);
        }

        m_Middles.Add(middles);
        return parts;

        int Middle(int a, int b)
        {
            var ends = new int2(math.min(a, b), math.max(a, b));
            if (known.TryAdd(ends, vertexCount + middles.Count))
                middles.Add(ends);
            return known[ends];
        }
    }
}
