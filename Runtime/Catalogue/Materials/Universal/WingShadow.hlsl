// Shadow maps of all lights.
#ifndef ALATE_WING_SHADOW
#define ALATE_WING_SHADOW

#include "WingInput.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/CommonMaterial.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Shadows.hlsl"

float3 _LightDirection;
float3 _LightPosition;

struct Attributes
{
    float4 position : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
    half4 colour : COLOR;
    ALATE_SHAPE_INPUT
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 position : SV_POSITION;
    float2 uv : TEXCOORD0;
    half4 colour : TEXCOORD1;
};

Varyings Vertex(Attributes corner)
{
    Varyings v = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(corner);
    ALATE_SHAPE_POSITION(corner, position)
    ALATE_SHAPE_NORMAL(corner)
    float3 place = PlaceOf(corner.position);
    float3 normal = TransformObjectToWorldNormal(corner.normal);
    #if defined(_CASTING_PUNCTUAL_LIGHT_SHADOW)
    float3 toLight = normalize(_LightPosition - place);
    #else
    float3 toLight = _LightDirection;
    #endif

    // A wing lit from below is lit: the bias must lead away from the light on either side.
    normal = _Cull < 0.5 && dot(normal, toLight) < 0 ? -normal : normal;
    v.position = OnScreen(ApplyShadowBias(place, normal, toLight));
    #if UNITY_REVERSED_Z
    v.position.z = min(v.position.z, UNITY_NEAR_CLIP_VALUE);
    #else
    v.position.z = max(v.position.z, UNITY_NEAR_CLIP_VALUE);
    #endif
    v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
    v.colour = corner.colour;
    return v;
}

half4 Fragment(Varyings v) : SV_Target
{
    clip(AlateShadowHole(Paint(v.colour, v.uv).a, v.position.xy));
    return 0;
}

#endif
