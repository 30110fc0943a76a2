// Where the corners of a wing are: as its mesh has them, in the loops of a baked insect, or deformed by the joints of a live one.
#ifndef ALATE_WING_SHAPE
#define ALATE_WING_SHAPE

#include "WingBaked.hlsl"
#include "WingSkinned.hlsl"

#if defined(_BAKED)
#define ALATE_SHAPE_INPUT float2 baked : TEXCOORD1;
#define ALATE_SHAPE_POSITION(corner, field) corner.field = float4(AlateBaked(corner.baked), 1);
#define ALATE_SHAPE_NORMAL(corner) corner.normal = normalize(AlateBaked(corner.baked + float2(0, 0.5)));
#elif defined(_SKINNED)
#define ALATE_SHAPE_INPUT float4 skin : TEXCOORD6;
#define ALATE_SHAPE_POSITION(corner, field) \
    AlateBlend alateBlend = AlateSkinNow(corner.skin); \
    ALATE_SHAPE_BEFORE(corner, field) \
    corner.field = float4(AlateSkinPosition(alateBlend, corner.skin, corner.field.xyz), 1);
#define ALATE_SHAPE_NORMAL(corner) corner.normal = AlateSkinDirection(alateBlend, corner.skin, corner.normal);
#if defined(ALATE_MOTION)
#define ALATE_SHAPE_BEFORE(corner, field) corner.last = AlateSkinBefore(corner.skin, corner.field.xyz);
#else
#define ALATE_SHAPE_BEFORE(corner, field)
#endif
#else
#define ALATE_SHAPE_INPUT
#define ALATE_SHAPE_POSITION(corner, field)
#define ALATE_SHAPE_NORMAL(corner)
#endif

// Of an instance.
half3 AlateTint()
{
    #if defined(_BAKED) && defined(INSTANCING_ON)
    return half3(UNITY_ACCESS_INSTANCED_PROP(AlateBaked, _BakeTint).rgb);
    #elif defined(_SKINNED)
    return half3(UNITY_ACCESS_INSTANCED_PROP(AlateSkinned, _SkinTint).rgb);
    #else
    return half3(1, 1, 1);
    #endif
}

#endif
