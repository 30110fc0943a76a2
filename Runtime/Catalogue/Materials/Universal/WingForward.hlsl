// The picture: main light, additional lights, ambient light and fog.
#ifndef ALATE_WING_FORWARD
#define ALATE_WING_FORWARD

#include "WingInput.hlsl"
#include "Packages/com.unity.render-pipelines.universal/ShaderLibrary/Lighting.hlsl"

// Whether lights are looked up by cluster. URP 17.1 renamed what URP 14 to 17.0 call Forward+; each defines its own name as 0 or 1 and knows no other.
#if defined(USE_CLUSTER_LIGHT_LOOP)
#define ALATE_CLUSTERED_LIGHTS USE_CLUSTER_LIGHT_LOOP
#else
#define ALATE_CLUSTERED_LIGHTS USE_FORWARD_PLUS
#endif

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
    float3 normal : TEXCOORD1;
    float3 place : TEXCOORD2;
    half4 colour : TEXCOORD3;
    half fog : TEXCOORD4;
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings Vertex(Attributes corner)
{
    Varyings v = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(corner);
    UNITY_TRANSFER_INSTANCE_ID(corner, v);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
    ALATE_SHAPE_POSITION(corner, position)
    ALATE_SHAPE_NORMAL(corner)
    v.place = PlaceOf(corner.position);
    v.position = OnScreen(v.place);
    v.normal = TransformObjectToWorldNormal(corner.normal);
    v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
    v.colour = corner.colour;
    v.fog = ComputeFogFactor(v.position.z);
    return v;
}

float3 LightOf(Light light, half3 colour, float3 normal, float3 toEye)
{
    #if defined(_LIGHT_LAYERS)
    if (!IsMatchingLightLayer(light.layerMask, GetMeshRenderingLayer()))
        return float3(0, 0, 0);
    #endif
    float3 arriving = light.color * (light.distanceAttenuation * light.shadowAttenuation);
    return AlateWingLight(colour, normal, toEye, light.direction, arriving, _Through, _Gloss, _Shine);
}

half4 Fragment(Varyings v) : SV_Target
{
    // Instanced insects each have their own ambient light.
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(v);
    half4 paint = Paint(v.colour, v.uv);
    float3 toEye = GetWorldSpaceNormalizeViewDir(v.place);
    half3 colour = AlateSide(paint.rgb, v.normal, toEye, _Cull < 0.5, _Underside) * AlateOpaqueShare(paint.a) * AlateTint();
    float3 normal = FacingNormal(v.normal, toEye);
    float3 sum = colour * lerp(SampleSH(normal), SampleSH(-normal), 0.5 * _Through);
    sum += LightOf(GetMainLight(TransformWorldToShadowCoord(v.place)), colour, normal, toEye);

    #if defined(_ADDITIONAL_LIGHTS) || ALATE_CLUSTERED_LIGHTS
    InputData inputData = (InputData)0;
    inputData.positionWS = v.place;
    inputData.normalizedScreenSpaceUV = GetNormalizedScreenSpaceUV(v.position);
    #if ALATE_CLUSTERED_LIGHTS
    for (uint sun = 0; sun < min(URP_FP_DIRECTIONAL_LIGHTS_COUNT, MAX_VISIBLE_LIGHTS); sun++)
    {
        sum += LightOf(GetAdditionalLight(sun, v.place, half4(1, 1, 1, 1)), colour, normal, toEye);
    }
    #endif
    uint count = GetAdditionalLightsCount();
    LIGHT_LOOP_BEGIN(count)
        sum += LightOf(GetAdditionalLight(lightIndex, v.place, half4(1, 1, 1, 1)), colour, normal, toEye);
    LIGHT_LOOP_END
    #endif

    return half4(MixFogColor(half3(sum), half3(unity_FogColor.rgb * AlateOpaqueShare(paint.a)), v.fog), paint.a);
}

#endif
