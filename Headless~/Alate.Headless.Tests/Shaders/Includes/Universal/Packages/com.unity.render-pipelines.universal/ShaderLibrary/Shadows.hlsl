#ifndef STANDIN_SHADOWS
#define STANDIN_SHADOWS
#include "Core.hlsl"
float4 TransformWorldToShadowCoord(float3 positionWS) { return float4(positionWS, 1); }
float3 ApplyShadowBias(float3 positionWS, float3 normalWS, float3 lightDirection) { return positionWS + normalWS + lightDirection; }
#endif
