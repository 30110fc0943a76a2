using System;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>The colour of every fine triangle of a surface, sRGB from 0 to 1.</summary>
internal static class WingPaint
{
    /// <summary>A wing without colours of its own: pale membrane.</summary>
    private static readonly float3 s_Membrane = new(0.81f, 0.78f, 0.67f);

    /// <summary>Width over which a pattern's colours blend, over the edge of a fine triangle.</summary>
    private const float k_Softness = 0.5f;

    /// <summary>By the wing's pattern where it has one, else by its vertex colours, else one pale colour.</summary>
    public static float3[] Of(InsectWing wing, FineTriangles fine)
    {
        if (wing.Pattern == null)
            return Of(wing.Colours, fine);
        float scale = wing.PatternScale;
        float3[] places = fine.Refine(Array.ConvertAll(wing.Surface.positions, position => (float3)position / scale));
        var colours = new float3[fine.Triangles.Count];
        for (int k = 0; k < colours.Length; k++)
        {
            int3 triangle = fine.Triangles[k];
            float3 a = places[triangle.x], b = places[triangle.y], c = places[triangle.z], centre = (a + b + c) / 3f;
            float softness = k_Softness * math.sqrt(math.length(math.cross(b - a, c - a)));
            Color colour = wing.Pattern.ColourAt(centre.x, centre.z, softness);
            colours[k] = new float3(colour.r, colour.g, colour.b);
        }

        return colours;
    }

    /// <summary>By vertex colours, or one pale colour without.</summary>
    public static float3[] Of(Color32[] vertices, FineTriangles fine)
    {
        var colours = new float3[fine.Triangles.Count];
        Array.Fill(colours, s_Membrane);
        if (vertices == null)
            return colours;
        for (int k = 0; k < colours.Length; k++)
        {
            float3 sum = 0f;
            for (int corner = 0; corner < 3; corner++)
            {
                int2 ends = fine.Ends(fine.Triangles[k][corner]);
                sum += Shading.ToLinear(Of(vertices[ends.x])) + Shading.ToLinear(Of(vertices[ends.y]));
            }

            colours[k] = Shading.ToEncoded(sum / 6f);
        }

        return colours;
    }

    private static float3 Of(Color32 colour) => new float3(colour.r, colour.g, colour.b) / 255f;
}
