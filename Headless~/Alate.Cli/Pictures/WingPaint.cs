using System;
using Alate.Cli.Flights;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>The colour of every fine triangle of a surface, linear light, and its opacity.</summary>
internal static class WingPaint
{
    /// <summary>A wing without colours of its own: pale membrane, sRGB.</summary>
    private static readonly float3 s_Membrane = new(0.84f, 0.79f, 0.66f);

    /// <summary>By the wing's pattern where it has one, else by its vertex colours, else one pale colour.</summary>
    public static float4[] Of(InsectWing wing, FineTriangles fine, PictureDetail detail)
    {
        if (wing.Pattern == null)
            return Of(wing.Colours, fine, detail);
        float scale = wing.PatternScale;
        float3[] places = fine.Refine(Array.ConvertAll(wing.Surface.positions, position => (float3)position / scale));
        var colours = new float4[fine.Triangles.Count];
        for (int k = 0; k < colours.Length; k++)
        {
            int3 triangle = fine.Triangles[k];
            float3 a = places[triangle.x], b = places[triangle.y], c = places[triangle.z], centre = (a + b + c) / 3f;
            float softness = detail.Softness * math.sqrt(math.length(math.cross(b - a, c - a)));
            Color colour = wing.Pattern.ColourAt(centre.x, centre.z, softness);
            colours[k] = new float4(Stepped(new float3(colour.r, colour.g, colour.b), detail.PatternStep), colour.a);
        }

        return colours;
    }

    /// <summary>By vertex colours, or one pale colour without.</summary>
    public static float4[] Of(Color32[] vertices, FineTriangles fine, PictureDetail detail)
    {
        var colours = new float4[fine.Triangles.Count];
        Array.Fill(colours, new float4(Shading.ToLinear(s_Membrane), 1f));
        if (vertices == null)
            return colours;
        float3[] lights = fine.Refine(
            Array.ConvertAll(vertices, colour => Shading.ToLinear(new float3(colour.r, colour.g, colour.b) / 255f)));
        float3[] opacities = fine.Refine(Array.ConvertAll(vertices, colour => new float3(colour.a / 255f)));
        for (int k = 0; k < colours.Length; k++)
        {
            int3 triangle = fine.Triangles[k];
            float3 light = (lights[triangle.x] + lights[triangle.y] + lights[triangle.z]) / 3f;
            float opacity = (opacities[triangle.x].x + opacities[triangle.y].x + opacities[triangle.z].x) / 3f;
            colours[k] = new float4(Stepped(Shading.ToEncoded(light), detail.VertexStep), opacity);
        }

        return colours;
    }

    private static float3 Stepped(float3 encoded, float step) => Shading.ToLinear(step * math.round(encoded / step));
}
