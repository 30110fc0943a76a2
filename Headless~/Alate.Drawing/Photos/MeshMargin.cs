using Alate.Geometry;

namespace Alate.Drawing;

/// <summary>The edges around a mesh.</summary>
internal static class MeshMargin
{
    /// <summary>Every edge that belongs to one triangle only.</summary>
    /// <param name="rest">[vertex] Rest positions; vertices at one place count as one.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    public static List<MarginEdge> Of(float3[] rest, int[] triangles)
    {
        int[] places = VertexWeld.Exact(rest), welded = Array.ConvertAll(triangles, vertex => places[vertex]);
        var edges = new MeshEdges(welded);
        var margin = new List<MarginEdge>();
        for (int k = 0; k < triangles.Length; k++)
        {
            int next = TriangleLinks.Next(k);
            if (edges.Uses(welded[k], welded[next]) == 1)
                margin.Add(new MarginEdge(k / 3, triangles[k], triangles[next]));
        }

        return margin;
    }
}
