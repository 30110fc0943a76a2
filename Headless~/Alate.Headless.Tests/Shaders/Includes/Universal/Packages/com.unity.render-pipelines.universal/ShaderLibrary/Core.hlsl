// Names and signatures of URP's Core.hlsl and of what it includes, as far as Alate's shader uses them. STANDIN_URP is the version: 1400, 1700 or 1701. What places a
// surface before a perspective camera does so, so that pictures can be drawn with it.
#ifndef STANDIN_CORE
#define STANDIN_CORE

#include "../../../../Instancing.hlsl"
#include "../../../../Light.hlsl"

#if STANDIN_URP >= 1701
    // URP defines this keyword's macros then, but warns in every project.
    #if defined(_FORWARD_PLUS_KEYWORD_DECLARED)
        #error URP 17.1 and newer warn of the keyword _FORWARD_PLUS
    #endif
    #if defined(_CLUSTER_LIGHT_LOOP)
        #define _ADDITIONAL_LIGHTS 1
        #define USE_CLUSTER_LIGHT_LOOP 1
    #else
        #define USE_CLUSTER_LIGHT_LOOP 0
    #endif
    #define STANDIN_CLUSTERS USE_CLUSTER_LIGHT_LOOP
#else
    #if defined(_FORWARD_PLUS)
        #define _ADDITIONAL_LIGHTS 1
        #define USE_FORWARD_PLUS 1
    #else
        #define USE_FORWARD_PLUS 0
    #endif
    #define STANDIN_CLUSTERS USE_FORWARD_PLUS
#endif

#define CBUFFER_START(name) cbuffer name {
#define CBUFFER_END };
#define TEXTURE2D(name) Texture2D name
#define TEXTURE2D_FLOAT(name) Texture2D name
#define SAMPLER(name) SamplerState name
#define SAMPLE_TEXTURE2D(name, sampled, uv) name.Sample(sampled, uv)
#define SAMPLE_TEXTURE2D_LOD(name, sampled, uv, level) name.SampleLevel(sampled, uv, level)
#define TRANSFORM_TEX(uv, name) ((uv).xy * name##_ST.xy + name##_ST.zw)
#define UNITY_REVERSED_Z 1
#define UNITY_NEAR_CLIP_VALUE 1.0
#define UNITY_UV_STARTS_AT_TOP 1

#define MAX_VISIBLE_LIGHTS 256
#if STANDIN_CLUSTERS
float4 _FPParams0;
#define URP_FP_DIRECTIONAL_LIGHTS_COUNT ((uint)_FPParams0.w)
#endif

float4x4 unity_ObjectToWorld, unity_MatrixPreviousM, unity_MatrixVP;
float4 unity_MotionVectorsParams, unity_RenderingLayer;
#if defined(UNITY_STEREO_INSTANCING_ENABLED)
float4x4 _NonJitteredViewProjMatrixStereo[2], _PrevViewProjMatrixStereo[2];
#define _NonJitteredViewProjMatrix _NonJitteredViewProjMatrixStereo[unity_StereoEyeIndex]
#define _PrevViewProjMatrix _PrevViewProjMatrixStereo[unity_StereoEyeIndex]
#else
float4x4 _NonJitteredViewProjMatrix, _PrevViewProjMatrix;
#endif
#if defined(INSTANCING_ON)
UNITY_INSTANCING_BUFFER_START(PerDraw0)
    UNITY_DEFINE_INSTANCED_PROP(float4x4, unity_ObjectToWorldArray)
UNITY_INSTANCING_BUFFER_END(unity_Builtins0)
UNITY_INSTANCING_BUFFER_START(PerDraw3)
    UNITY_DEFINE_INSTANCED_PROP(float4x4, unity_PrevObjectToWorldArray)
UNITY_INSTANCING_BUFFER_END(unity_Builtins3)
#define UNITY_MATRIX_M UNITY_ACCESS_INSTANCED_PROP(unity_Builtins0, unity_ObjectToWorldArray)
#define UNITY_PREV_MATRIX_M UNITY_ACCESS_INSTANCED_PROP(unity_Builtins3, unity_PrevObjectToWorldArray)
#else
#define UNITY_MATRIX_M unity_ObjectToWorld
#define UNITY_PREV_MATRIX_M unity_MatrixPreviousM
#endif
float4 unity_FogColor;
float3 _WorldSpaceCameraPos;

struct InputData
{
    float3 positionWS;
    float4 positionCS;
    float3 normalWS;
    half3 viewDirectionWS;
    float4 shadowCoord;
    half fogCoord;
    half3 vertexLighting;
    half3 bakedGI;
    float2 normalizedScreenSpaceUV;
    half4 shadowMask;
};

float3 TransformObjectToWorld(float3 positionOS) { return mul(UNITY_MATRIX_M, float4(positionOS, 1)).xyz; }
float4 TransformWorldToHClip(float3 positionWS) { return mul(unity_MatrixVP, float4(positionWS, 1)); }
float4 TransformObjectToHClip(float3 positionOS) { return TransformWorldToHClip(TransformObjectToWorld(positionOS)); }
float3 TransformObjectToWorldNormal(float3 normalOS, bool doNormalize = true)
{
    float3 normal = StandinNormal((float3x3)UNITY_MATRIX_M, normalOS);
    return doNormalize ? normalize(normal) : normal;
}
float3 GetWorldSpaceNormalizeViewDir(float3 positionWS) { return normalize(_WorldSpaceCameraPos - positionWS); }
uint GetMeshRenderingLayer() { return asuint(unity_RenderingLayer.x); }
float2 GetNormalizedScreenSpaceUV(float4 positionCS) { return positionCS.xy; }
#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
float ComputeFogFactor(float zPositionCS) { return zPositionCS; }
float3 MixFogColor(float3 fragColor, float3 fogColor, float fogFactor) { return lerp(fogColor, fragColor, fogFactor); }
#else
float ComputeFogFactor(float zPositionCS) { return 0; }
float3 MixFogColor(float3 fragColor, float3 fogColor, float fogFactor) { return fragColor; }
#endif

#endif
