using UnityEngine;

namespace Alate.Cli;

/// <summary>Texture with the joints of wings that the graphics card deforms: two texels each, the parts of a dual quaternion.</summary>
internal sealed class CardSkins
{
    /// <summary>Name of the texture in a material, and of the first joint of a renderer.</summary>
    public const string Map = "_SkinMap", Start = "_SkinStart";

    /// <summary>Keyword of materials whose wings are deformed so.</summary>
    public const string Keyword = "_SKINNED";

    private readonly Color[] m_Texels;

    /// <param name="map">The texture, a joint beside the other in rows of equal length.</param>
    public CardSkins(Texture2D map)
    {
        m_Texels = map.CopyPixels();
    }

    /// <summary>Shape of a renderer, as the shader has it.</summary>
    /// <param name="shape">The mesh, undeformed.</param>
    /// <param name="start">First joint of the renderer.</param>
    public MeshShape Shape(MeshShape shape, float start)
    {
        var places = new float3[shape.Places.Length];
        var normals = new float3[shape.Normals.Length];
        for (int v = 0; v < places.Length; v++)
        {
            float4 skin = shape.Joints[v];
            (places[v], normals[v]) = (shape.Places[v], shape.Normals[v]);
            if (skin.x < 0f)
                continue;
            (float4 real, float4 dual) = Blend(skin, 2 * (int)start);
            float3 q = real.xyz, e = dual.xyz, place = places[v], normal = normals[v];
            float scale = 2f / math.dot(real, real);
            places[v] += scale * (math.cross(q, math.cross(q, place) + real.w * place + e) + real.w * e - dual.w * q);
            normals[v] += scale * math.cross(q, math.cross(q, normal) + real.w * normal);
        }

        return shape with { Places = places, Normals = normals };
    }

    // Of the four joints of a cell; quaternions of either sign turn alike, and are added on the side of the first.
    private (float4 Real, float4 Dual) Blend(float4 skin, int first)
    {
        int texel = first + 2 * (int)skin.x, across = 2 * (int)skin.y;
        float4 pivot = Texel(texel), real = 0f, dual = 0f;
        Add(texel, (1f - skin.z) * (1f - skin.w));
        Add(texel + 2, (1f - skin.z) * skin.w);
        Add(texel + across, skin.z * (1f - skin.w));
        Add(texel + across + 2, skin.z * skin.w);
        return (real, dual);

        void Add(int joint, float weight)
        {
            float4 turn = Texel(joint);
            float share = math.dot(turn, pivot) < 0f ? -weight : weight;
            real += share * turn;
            dual += share * Texel(joint + 1);
        }
    }

    private float4 Texel(int texel)
    {
        Color value = m_Texels[texel];
        return new float4(value.r, value.g, value.b, value.a);
    }
}
