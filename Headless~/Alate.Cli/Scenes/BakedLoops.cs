using UnityEngine;

namespace Alate.Cli;

/// <summary>Texture of baked loops: where each vertex is at each frame, and its normal in the upper half.</summary>
internal sealed class BakedLoops
{
    /// <summary>Name of the texture in a material.</summary>
    public const string Map = "_BakeMap";

    private readonly int2 m_Size;
    private readonly Color[] m_Texels;

    /// <param name="map">The texture.</param>
    public BakedLoops(Texture2D map)
    {
        m_Size = new int2(map.width, map.height);
        m_Texels = map.CopyPixels();
    }

    /// <summary>Shape of an instance, as the shader has it.</summary>
    /// <param name="shape">The mesh.</param>
    /// <param name="rows">Rows before and after, how far the phase lies between them, and the share of the next loop.</param>
    /// <param name="next">Rows of the next loop, and how far the phase lies between them.</param>
    public MeshShape Shape(MeshShape shape, float4 rows, float4 next) => shape with
    {
        Places = Array.ConvertAll(shape.Baked, first => Blended(first, rows, next)),
        Normals = Array.ConvertAll(shape.Baked, first => math.normalizesafe(Blended(first + new float2(0f, 0.5f), rows, next))),
    };

    private float3 Blended(float2 first, float4 rows, float4 next)
    {
        float3 value = Loop(first, rows.xyz);
        return rows.w > 0f ? math.lerp(value, Loop(first, next.xyz), rows.w) : value;
    }

    private float3 Loop(float2 first, float3 rows) => math.lerp(Texel(first, rows.x), Texel(first, rows.y), rows.z);

    private float3 Texel(float2 first, float row)
    {
        int2 at = math.clamp((int2)math.floor(first * m_Size + new float2(0f, row)), 0, m_Size - 1);
        Color texel = m_Texels[at.y * m_Size.x + at.x];
        return new float3(texel.r, texel.g, texel.b);
    }
}
