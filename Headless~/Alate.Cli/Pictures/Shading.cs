using System;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Cli.Pictures;

/// <summary>
/// The light of the pictures: a key light from the viewer's upper left, a bright sky, wings that let light through, and a rim where a surface turns away.
/// All numbers are chosen by eye.
/// </summary>
internal sealed class Shading
{
    private const float k_Ambient = 0.42f, k_Key = 0.68f, k_Through = 0.42f, k_Rim = 0.16f, k_RimPower = 3f, k_Sky = 0.16f;

    /// <summary>Steps between the shades of a channel: small enough to look smooth, large enough to merge neighbouring triangles.</summary>
    private const int k_Step = 9;

    private static readonly float3 s_ThroughTint = new(1.1f, 0.98f, 0.82f);
    private readonly float3 m_Towards, m_Key;

    public Shading(PictureCamera camera)
    {
        m_Towards = camera.Towards;
        m_Key = camera.Direction(-0.45f, 0.8f, 0.55f);
    }

    /// <summary>The shade of a surface.</summary>
    /// <param name="colour">sRGB, 0 to 1.</param>
    /// <param name="normal">Unit vector on the body; which side it points to does not matter.</param>
    /// <param name="isThin">A wing, which light passes; else a body.</param>
    public int Shade(float3 colour, float3 normal, bool isThin)
    {
        float facing = math.dot(normal, m_Towards);
        normal = facing < 0f ? -normal : normal;
        float key = math.dot(normal, m_Key);
        float through = isThin ? k_Through * math.max(-key, 0f) : 0f;
        float rim = k_Rim * math.pow(1f - math.min(math.abs(facing), 1f), k_RimPower);
        float light = k_Ambient + k_Sky * normal.y + k_Key * math.max(key, 0f);
        float3 linear = ToLinear(colour);
        float3 lit = linear * (light + through * s_ThroughTint) + rim * (0.4f * linear + 0.25f);
        return Quantised(ToEncoded(lit));
    }

    /// <summary>The mean colour of three vertices, sRGB, 0 to 1.</summary>
    public static float3 Mean(Color32 a, Color32 b, Color32 c) =>
        ToEncoded((ToLinear(Of(a)) + ToLinear(Of(b)) + ToLinear(Of(c))) / 3f);

    private static float3 Of(Color32 colour) => new float3(colour.r, colour.g, colour.b) / 255f;

    private static float3 ToLinear(float3 encoded) => math.pow(encoded, 2.2f);

    private static float3 ToEncoded(float3 linear) => math.pow(math.saturate(linear), 1f / 2.2f);

    private static int Quantised(float3 colour)
    {
        int3 steps = (int3)math.round(255f * colour / k_Step) * k_Step;
        steps = math.min(steps, 255);
        return (steps.x << 16) | (steps.y << 8) | steps.z;
    }
}
