// What every pass of Alate/Wing shares in URP: the material's properties, its paint, and the place of a vertex. All passes place vertices by one function, so that
// the depth of a prepass is to the last bit that of the picture.
#ifndef ALATE_WING_INPUT
#define ALATE_WING_INPUT

#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Core.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Color.hlsl"
#include "../WingLight.hlsl"

CBUFFER_START(UnityPerMaterial)
    float4 _MainTex_ST;
    half4 _Color;
    half4 _Underside;
    half _VertexColours;
    half _Through;
    half _Gloss;
    half _Shine;
    half _Cull;
    half _Translucent;
    half _Cut;
    half _AlphaToMask;
    half _SrcBlend;
    half _DstBlend;
    half _ZWrite;
    float4 _BakeMap_TexelSize;
    float4 _SkinMap_TexelSize;
    float _SkinLast;
CBUFFER_END

TEXTURE2D(_MainTex);
SAMPLER(sampler_MainTex);
// On phones a texture is read with half the bits unless it is declared so.
TEXTURE2D_FLOAT(_BakeMap);
SAMPLER(sampler_BakeMap);
TEXTURE2D_FLOAT(_SkinMap);
SAMPLER(sampler_SkinMap);
#define ALATE_BAKE_SAMPLE(coordinates) SAMPLE_TEXTURE2D_LOD(_BakeMap, sampler_BakeMap, coordinates, 0).xyz
#define ALATE_SKIN_SAMPLE(coordinates) SAMPLE_TEXTURE2D_LOD(_SkinMap, sampler_SkinMap, coordinates, 0)
#include "../WingShape.hlsl"

// For passes that need no colour.
void CutMarginAt(float2 uv)
{
    #if defined(_CUT)
    AlateCutMargin(SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, uv).a * _Color.a);
    #endif
}

half4 Paint(half4 vertexColour, float2 uv)
{
    #ifndef UNITY_COLORSPACE_GAMMA
    vertexColour.rgb = SRGBToLinear(vertexColour.rgb);
    #endif
    half4 paint = SAMPLE_TEXTURE2D(_MainTex, sampler_MainTex, uv) * _Color * lerp(half4(1, 1, 1, 1), vertexColour, _VertexColours);
    #if defined(_CUT)
    paint.a = AlateCutMargin(paint.a);
    #else
    paint.a = lerp(1, paint.a, _Translucent);
    #endif
    return paint;
}

float3 PlaceOf(float4 position)
{
    return TransformObjectToWorld(position.xyz);
}

float4 OnScreen(float3 place)
{
    return TransformWorldToHClip(place);
}

// Towards the eye where a wing is seen from its lower side.
float3 FacingNormal(float3 normal, float3 toEye)
{
    return AlateFacing(normalize(normal), toEye, _Cull < 0.5);
}

#endif
