#ifndef STANDIN_LIGHTING
#define STANDIN_LIGHTING
#include "Core.hlsl"
#include "Shadows.hlsl"

struct Light
{
    half3 direction;
    half3 color;
    float distanceAttenuation;
    half shadowAttenuation;
    uint layerMask;
};

#if STANDIN_CLUSTERS
struct ClusterIterator { uint next; };
ClusterIterator ClusterInit(float2 normalizedScreenSpaceUV, float3 positionWS, int headerIndex) { ClusterIterator i; i.next = (uint)positionWS.x; return i; }
bool ClusterNext(inout ClusterIterator i, out uint entityIndex) { entityIndex = i.next++; return entityIndex < 8u; }
#define LIGHT_LOOP_BEGIN(lightCount) { \
    uint lightIndex; \
    ClusterIterator clusters = ClusterInit(inputData.normalizedScreenSpaceUV, inputData.positionWS, 0); \
    [loop] while (ClusterNext(clusters, lightIndex)) { \
        lightIndex += URP_FP_DIRECTIONAL_LIGHTS_COUNT;
#define LIGHT_LOOP_END } }
#else
#define LIGHT_LOOP_BEGIN(lightCount) for (uint lightIndex = 0u; lightIndex < lightCount; ++lightIndex) {
#define LIGHT_LOOP_END }
#endif

float4 _MainLightPosition, _MainLightColor, _AdditionalLightsCount;

Light GetMainLight()
{
    Light light;
    light.direction = _MainLightPosition.xyz;
    light.color = _MainLightColor.rgb;
    light.distanceAttenuation = 1;
    light.shadowAttenuation = 1;
    light.layerMask = 1;
    return light;
}

Light GetMainLight(float4 shadowCoord) { return GetMainLight(); }
Light GetAdditionalLight(uint i, float3 positionWS, half4 shadowMask) { return GetMainLight(); }
int GetAdditionalLightsCount() { return (int)_AdditionalLightsCount.x; }
#if defined(_LIGHT_LAYERS)
bool IsMatchingLightLayer(uint lightLayers, uint renderingLayers) { return (lightLayers & renderingLayers) != 0; }
#endif
half3 SampleSH(float3 normalWS) { return StandinAmbient(normalWS); }

#endif
