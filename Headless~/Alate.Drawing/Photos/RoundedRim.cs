using Alate.Geometry;

namespace Alate.Drawing;

/// <summary>Margins of a flat mesh as smooth curves just inside its rims, wherever its vertices are.</summary>
internal sealed class RoundedRim
{
    private readonly List<(int[] Vertices, bool[] Bulges)> m_Rims = [];

    /// <param name="rest">[vertex] Rest positions in the plane y = 0; vertices at one place count as one.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    public RoundedRim(float3[] rest, int[] triangles)
    {
        int[] places = VertexWeld.Exact(rest);
        foreach (int[] rim in MeshRim.Of(Array.ConvertAll(triangles, vertex => places[vertex])))
        {
            PlanPoint[] corners = Corners(rim);
            if (Polygon.Area(corners) < 0.0)
            {
                Array.Reverse(rim);
                corners = Corners(rim);
            }

            m_Rims.Add((rim, InnerCurve.Bulges(corners)));
        }

        PlanPoint[] Corners(int[] rim) => Array.ConvertAll(rim, vertex => new PlanPoint(rest[vertex].x, rest[vertex].z));
    }

    /// <summary>Tells the vertices that lie on a rim.</summary>
    /// <param name="count">Vertices of the mesh.</param>
    public bool[] Vertices(int count)
    {
        bool[] isRim = new bool[count];
        foreach (int vertex in m_Rims.SelectMany(rim => rim.Vertices))
            isRim[vertex] = true;
        return isRim;
    }

    /// <summary>Straight pieces of the curves, each with the vertex next to it.</summary>
    /// <param name="places">[vertex] Where the mesh is.</param>
    public IEnumerable<(int Vertex, float3 From, float3 To)> Pieces(float3[] places)
    {
        foreach ((int[] vertices, bool[] bulges) in m_Rims)
        {
            PlanPoint[] across = Curve(vertex => new PlanPoint(places[vertex].x, places[vertex].y)),
                depths = Curve(vertex => new PlanPoint(places[vertex].z, 0.0));
            for (int k = 0; k < across.Length; k++)
                yield return (vertices[k / InnerCurve.PiecesOfACorner], At(k), At((k + 1) % across.Length));

            PlanPoint[] Curve(Converter<int, PlanPoint> at) => InnerCurve.Of(Array.ConvertAll(vertices, at), bulges);
            float3 At(int k) => new((float)across[k].x, (float)across[k].z, (float)depths[k].x);
        }
    }
}
