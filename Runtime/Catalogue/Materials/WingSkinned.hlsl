// Live wings that the graphics card deforms: a texture holds the dual quaternions of the joints of all wings, two texels each, and an instance says where those of its
// mesh begin, and its tint. A corner knows the first joint of its cell, how many joints further the next chain has its own, and its place in the cell. Needs _SkinMap_TexelSize,
// _SkinLast (texels to what the last picture showed) and ALATE_SKIN_SAMPLE(coordinates).
#ifndef ALATE_WING_SKINNED
#define ALATE_WING_SKINNED

#if defined(_SKINNED)

UNITY_INSTANCING_BUFFER_START(AlateSkinned)
    UNITY_DEFINE_INSTANCED_PROP(float, _SkinStart)
    UNITY_DEFINE_INSTANCED_PROP(float4, _SkinTint)
UNITY_INSTANCING_BUFFER_END(AlateSkinned)

// The width is a power of two: every step is exact.
#define ALATE_SKIN_WIDTH 1024.0

// A sum of transforms, not normalised.
struct AlateBlend
{
    float4 real;
    float4 dual;
};

float4 AlateSkinTexel(float texel)
{
    float row = floor(texel / ALATE_SKIN_WIDTH);
    return ALATE_SKIN_SAMPLE(float2((texel - row * ALATE_SKIN_WIDTH + 0.5) / ALATE_SKIN_WIDTH, (row + 0.5) * _SkinMap_TexelSize.y));
}

// Quaternions of either sign turn alike: those of a cell are added on the side of its first.
void AlateSkinAdd(inout AlateBlend blend, float4 pivot, float texel, float weight)
{
    float4 real = AlateSkinTexel(texel);
    float share = dot(real, pivot) < 0 ? -weight : weight;
    blend.real += share * real;
    blend.dual += share * AlateSkinTexel(texel + 1);
}

// first: the first texel of the instance.
AlateBlend AlateSkinBlend(float4 skin, float first)
{
    float texel = first + 2 * skin.x, across = 2 * skin.y;
    float2 place = skin.zw;
    float4 pivot = AlateSkinTexel(texel);
    float weight = (1 - place.x) * (1 - place.y);
    AlateBlend blend;
    blend.real = weight * pivot;
    blend.dual = weight * AlateSkinTexel(texel + 1);
    AlateSkinAdd(blend, pivot, texel + 2, (1 - place.x) * place.y);
    AlateSkinAdd(blend, pivot, texel + across, place.x * (1 - place.y));
    AlateSkinAdd(blend, pivot, texel + across + 2, place.x * place.y);
    return blend;
}

// What belongs to no wing has no joint, below 0, and stays.
AlateBlend AlateSkinNow(float4 skin)
{
    return AlateSkinBlend(skin, 2 * UNITY_ACCESS_INSTANCED_PROP(AlateSkinned, _SkinStart));
}

float3 AlateSkinPosition(AlateBlend blend, float4 skin, float3 place)
{
    float3 q = blend.real.xyz, e = blend.dual.xyz;
    float3 moved = cross(q, cross(q, place) + blend.real.w * place + e) + blend.real.w * e - blend.dual.w * q;
    return skin.x < 0 ? place : place + 2 / dot(blend.real, blend.real) * moved;
}

// Normals and tangents.
float3 AlateSkinDirection(AlateBlend blend, float4 skin, float3 direction)
{
    float3 q = blend.real.xyz;
    float3 turned = cross(q, cross(q, direction) + blend.real.w * direction);
    return skin.x < 0 ? direction : direction + 2 / dot(blend.real, blend.real) * turned;
}

#if defined(ALATE_MOTION)
float3 AlateSkinBefore(float4 skin, float3 place)
{
    return AlateSkinPosition(
        AlateSkinBlend(skin, 2 * UNITY_ACCESS_INSTANCED_PROP(AlateSkinned, _SkinStart) + _SkinLast), skin, place);
}
#endif

#endif

#endif
