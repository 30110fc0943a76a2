using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Cli.Pictures;

/// <summary>A surface to be painted in many poses: its triangles, colours and margin.</summary>
internal sealed class PictureSurface
{
    private readonly int[] m_Triangles;
    private readonly FineTriangles m_Fine;
    private readonly float4[] m_Colours;
    private readonly float4? m_Ground;
    private readonly List<MarginEdge> m_Margin;
    private readonly PictureDetail m_Detail;
    private readonly bool m_IsThin;
    private readonly int m_Index;

    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="rest">[vertex] Rest positions; vertices at one place count as one when the margin is sought.</param>
    /// <param name="triangles">Three vertex indices a triangle.</param>
    /// <param name="paint">The colour of each fine triangle, with its opacity.</param>
    /// <param name="detail">How finely it is parted.</param>
    /// <param name="isThin">A wing; else a closed body without a margin.</param>
    public PictureSurface(int index, float3[] rest, int[] triangles, Func<FineTriangles, float4[]> paint, PictureDetail detail, bool isThin)
    {
        m_Index = index;
        m_Detail = detail;
        m_Triangles = triangles;
        m_Fine = new FineTriangles(rest.Length, triangles, isThin ? detail.LeastTriangles : 0);
        m_Colours = paint(m_Fine);
        int colours = isThin ? detail.WingColours : detail.BodyColours;
        m_Ground = colours > 0 ? Palette.Reduce(m_Colours, colours, detail.Alike) : null;
        m_IsThin = isThin;
        m_Margin = isThin ? MeshMargin.Of(rest, triangles) : [];
    }

    /// <summary>Hands the surface to a painter.</summary>
    /// <param name="painter">Who paints it.</param>
    /// <param name="vertices">[vertex] Places on the picture, z the depth.</param>
    /// <param name="normals">[vertex] Unit normals on the body.</param>
    /// <param name="picture">Places of all that is painted; the surface's are added.</param>
    /// <param name="shading">The light.</param>
    public void Paint(Painter painter, float3[] vertices, float3[] normals, List<float3> picture, Shading shading)
    {
        float3[] places = m_Fine.Refine(vertices), upright = m_Fine.Refine(normals);
        int first = picture.Count;
        picture.AddRange(places);
        for (int k = 0; k < m_Fine.Parents.Count; k++)
        {
            int3 whole = m_Fine.Parents[k];
            float3 normal = math.normalizesafe(upright[whole.x] + upright[whole.y] + upright[whole.z]);
            float depth = (places[whole.x].z + places[whole.y].z + places[whole.z].z) / 3f;
            if (m_Ground is float4 ground)
                Add(painter, whole, ground, normal, places, first, shading, null);
            if (math.abs(Turn(whole, places)) < 2f * m_Detail.LeastParted)
            {
                Paint(painter, whole, m_Ground == null ? Mean(4 * k) : m_Colours[4 * k + 3], normal, places, first, shading, depth);
                continue;
            }

            for (int part = 4 * k; part < 4 * k + 4; part++)
                Paint(painter, m_Fine.Triangles[part], m_Colours[part], normal, places, first, shading, depth);
        }

        foreach (MarginEdge rim in m_Margin)
        {
            int2 ends = new int2(rim.A, rim.B) + first;
            painter.AddLine(InsectScene.MarginLine, ends, vertices[rim.A], vertices[rim.B], Depth(rim.Triangle, vertices));
        }
    }

    // What has the colour of the ground is painted with it; the rest right after the triangle of which it is a part.
    private void Paint(Painter painter, int3 corners, float4 colour, float3 normal, float3[] places, int first, Shading shading, float depth)
    {
        if (m_Ground is not float4 ground)
            Add(painter, corners, colour, normal, places, first, shading, null);
        else if (math.any(colour != ground))
            Add(painter, corners, colour, normal, places, first, shading, depth);
    }

    private void Add(Painter painter, int3 corners, float4 colour, float3 normal, float3[] places, int first, Shading shading, float? above)
    {
        float turn = Turn(corners, places);
        if (turn == 0f)
            return;
        var shape = new PaintedShape(shading.Shade(colour.xyz, normal, m_IsThin), false, turn < 0f, Glass.Of(m_Index, colour.w, m_Detail.GlassStep));
        painter.AddTriangle(shape, corners + first, places[corners.x], places[corners.y], places[corners.z], above);
    }

    private float4 Mean(int first) => 0.25f * (m_Colours[first] + m_Colours[first + 1] + m_Colours[first + 2] + m_Colours[first + 3]);

    private static float Turn(int3 corners, float3[] places)
    {
        float3 edge = places[corners.y] - places[corners.x], other = places[corners.z] - places[corners.x];
        return edge.x * other.y - edge.y * other.x;
    }

    private float Depth(int triangle, float3[] vertices) => math.min(
        vertices[m_Triangles[3 * triangle]].z,
        math.min(vertices[m_Triangles[3 * triangle + 1]].z, vertices[m_Triangles[3 * triangle + 2]].z));
}
