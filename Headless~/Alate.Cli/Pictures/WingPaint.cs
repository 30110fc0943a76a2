using System;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>The colour of every fine triangle of a surface, linear light.</summary>
internal static class WingPaint
{
    /// <summary>A wing without colours of its own: pale membrane, sRGB.</summary>
    private static readonly float3 s_Membrane = new(0.84f, 0.79f, 0.66f);

    /// <summary>Width over which a pattern's colours blend, over the edge of a fine triangle.</summary>
    private const float k_Softness = 0.5f;

    /// <summary>Steps of a colour, sRGB: neighbours that differ by less are painted in one go.</summary>
    private const float k_Step = 0.08f;

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
            colours[k] = Stepped(new float3(colour.r, colour.g, colour.b));
        }

        return colours;
    }

    /// <summary>By vertex colours, or one pale colour without.</summary>
    public static float3[] Of(Color32[] vertices, FineTriangles fine)
    {
        var colours = new float3[fine.Triangles.Count];
        Array.Fill(colours, Shading.ToLinear(s_Membrane));
        if (vertices == null)
            return colours;
        float3[] lights = fine.Refine(
            Array.ConvertAll(vertices, colour => Shading.ToLinear(new float3(colour.r, colour.g, colour.b) / 255f)));
        for (int k = 0; k < colours.Length; k++)
        {
            int3 triangle = fine.Triangles[k];
            colours[k] = Stepped(Shading.ToEncoded((lights[triangle.x] + lights[triangle.y] + lights[triangle.z]) / 3f));
        }

        return colours;
    }

    private static float3 Stepped(float3 encoded) => Shading.ToLinear(k_Step * math.round(encoded / k_Step));
}
