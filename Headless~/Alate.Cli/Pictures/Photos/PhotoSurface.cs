using System;
using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures.Photos;

/// <summary>A surface as a photo shows it: shaded and coloured again at every sample.</summary>
internal sealed class PhotoSurface
{
    /// <summary>Half the width of the line around a wing, pixels.</summary>
    private const float k_HalfLine = 0.55f;

    /// <summary>Light of that line over the wing's own.</summary>
    private const float k_LineLight = 0.3f;

    /// <summary>A wing without colours of its own: pale membrane, linear light.</summary>
    private static readonly float4 s_Membrane = new(Shading.ToLinear(new float3(0.84f, 0.79f, 0.66f)), 1f);

    private readonly int m_Index;
    private readonly int[] m_Triangles;
    private readonly float4[] m_Values;
    private readonly Func<float4, float, float4> m_ColourOf;
    private readonly List<MarginEdge> m_Margin;
    private readonly bool m_IsThin;

    private PhotoSurface(
        int index, int[] triangles, float4[] values, Func<float4, float, float4> colourOf, bool isThin, List<MarginEdge> margin)
    {
        m_Index = index;
        m_Triangles = triangles;
        m_Values = values;
        m_ColourOf = colourOf;
        m_IsThin = isThin;
        m_Margin = margin;
    }

    /// <summary>A body, in the colours of its vertices.</summary>
    public static PhotoSurface Of(SurfaceMesh body) => new(
        0, body.triangles, Array.ConvertAll(body.colours, Linear), (colour, _) => colour, false, []);

    /// <summary>A wing with a line around it: in its pattern, its picture or the colours of its vertices, or pale where it has none.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="wing">The wing.</param>
    public static PhotoSurface Of(int index, RecordedWing wing)
    {
        InsectWing own = wing.Wing;
        if (own.Pattern is WingPattern pattern)
            return Thin(index, wing, Array.ConvertAll(own.Surface.positions, place => new float4(place, 0f) / own.PatternScale), (place, softness) => Linear(pattern.ColourAt(place.x, place.z, softness)));
        if (own.Surface.uvs != null && own.Texture is WingTexture picture)
            return Thin(index, wing, Array.ConvertAll(own.Surface.uvs, uv => new float4(uv, 0f, 0f)), (place, _) => picture.ColourAt(place.xy));
        if (own.Colours != null)
            return Thin(index, wing, Array.ConvertAll(own.Colours, Linear), (colour, _) => colour);
        return Thin(index, wing, new float4[wing.Rest.Length], (_, _) => s_Membrane);
    }

    /// <summary>A wing in the colours of numbers.</summary>
    /// <param name="index">Its number among the surfaces of the picture.</param>
    /// <param name="wing">The wing.</param>
    /// <param name="values">[vertex] The numbers.</param>
    /// <param name="colourOf">Linear light of a number.</param>
    public static PhotoSurface Of(int index, RecordedWing wing, float[] values, Func<float, float3> colourOf) =>
        Thin(index, wing, Array.ConvertAll(values, value => new float4(value, 0f, 0f, 0f)), (value, _) => new float4(colourOf(value.x), 1f));

    private static PhotoSurface Thin(int index, RecordedWing wing, float4[] values, Func<float4, float, float4> colourOf) =>
        new(index, wing.Triangles, values, colourOf, true, MeshMargin.Of(wing.Rest, wing.Triangles));

    /// <summary>Draws the surface.</summary>
    /// <param name="grid">Where to.</param>
    /// <param name="places">[vertex] x and y in samples, z the depth.</param>
    /// <param name="normals">[vertex] Unit vectors on the body.</param>
    /// <param name="shading">The light.</param>
    /// <param name="softness">Width over which the colours of a wing's pattern blend, wing lengths.</param>
    public void Draw(SampleGrid grid, float3[] places, float3[] normals, Shading shading, float softness)
    {
        for (int k = 0; k < m_Triangles.Length; k += 3)
        {
            int3 t = new(m_Triangles[k], m_Triangles[k + 1], m_Triangles[k + 2]);
            TriangleSamples.Visit(places[t.x].xy, places[t.y].xy, places[t.z].xy, (x, y, share) =>
            {
                float depth = math.dot(share, new float3(places[t.x].z, places[t.y].z, places[t.z].z));
                if (!grid.IsSeen(x, y, depth))
                    return;
                float4 colour = m_ColourOf(share.x * m_Values[t.x] + share.y * m_Values[t.y] + share.z * m_Values[t.z], softness);
                float3 normal = math.normalizesafe(share.x * normals[t.x] + share.y * normals[t.y] + share.z * normals[t.z]);
                grid.Add(x, y, depth, new float4(shading.Light(colour.xyz, normal, m_IsThin), colour.w), m_Index);
            });
        }

        foreach (MarginEdge edge in m_Margin)
        {
            float3 colour = k_LineLight * m_ColourOf(0.5f * (m_Values[edge.A] + m_Values[edge.B]), softness).xyz;
            DrawLine(grid, places[edge.A], places[edge.B], new float4(colour, 1f));
        }
    }

    // Two triangles, a little nearer than the wing, and beyond both ends so that lines in a row join.
    private void DrawLine(SampleGrid grid, float3 from, float3 to, float4 light)
    {
        const float k_Nearer = 0.9985f;
        float2 along = k_HalfLine * SampleGrid.k_Fineness * math.normalizesafe(to.xy - from.xy), aside = new(-along.y, along.x);
        float2 start = from.xy - 0.5f * along, end = to.xy + 0.5f * along;
        TriangleSamples.Visitor draw = (x, y, _) =>
        {
            float depth = k_Nearer * math.min(from.z, to.z);
            if (grid.IsSeen(x, y, depth))
                grid.Add(x, y, depth, light, m_Index);
        };
        TriangleSamples.Visit(start - aside, end - aside, end + aside, draw);
        TriangleSamples.Visit(start - aside, end + aside, start + aside, draw);
    }

    private static float4 Linear(Color32 colour) => Linear((Color)colour);

    private static float4 Linear(Color colour) => new(Shading.ToLinear(new float3(colour.r, colour.g, colour.b)), colour.a);
}
