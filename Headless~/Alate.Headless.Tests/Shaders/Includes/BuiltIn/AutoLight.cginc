// Names and signatures of the built-in pipeline's AutoLight.cginc: each kind of light and shadow has coordinates of its own, computed from v.vertex and o.pos.
#ifndef STANDIN_AUTO_LIGHT
#define STANDIN_AUTO_LIGHT

float4x4 unity_WorldToLight;

// Without the keyword of a kind of light Unity takes it for a directional one.
#if defined(POINT) || defined(POINT_COOKIE)
#define STANDIN_LIGHT_COORDS(index) float3 _LightCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_LIGHT(o) o._LightCoord = mul(unity_WorldToLight, mul(unity_ObjectToWorld, v.vertex)).xyz;
#define STANDIN_ATTENUATION(worldPos) saturate(mul(unity_WorldToLight, float4(worldPos, 1)).x)
#elif defined(SPOT)
#define STANDIN_LIGHT_COORDS(index) float4 _LightCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_LIGHT(o) o._LightCoord = mul(unity_WorldToLight, mul(unity_ObjectToWorld, v.vertex));
#define STANDIN_ATTENUATION(worldPos) saturate(mul(unity_WorldToLight, float4(worldPos, 1)).w)
#elif defined(DIRECTIONAL_COOKIE)
#define STANDIN_LIGHT_COORDS(index) float2 _LightCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_LIGHT(o) o._LightCoord = mul(unity_WorldToLight, mul(unity_ObjectToWorld, v.vertex)).xy;
#define STANDIN_ATTENUATION(worldPos) saturate(mul(unity_WorldToLight, float4(worldPos, 1)).y)
#else
#define STANDIN_LIGHT_COORDS(index)
#define STANDIN_TRANSFER_LIGHT(o)
#define STANDIN_ATTENUATION(worldPos) 1
#endif

#if defined(SHADOWS_SCREEN)
#define STANDIN_SHADOW_COORDS(index) float4 _ShadowCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_SHADOW(o) o._ShadowCoord = ComputeScreenPos(o.pos);
#define STANDIN_SHADOW(i) i._ShadowCoord.x
#elif defined(SHADOWS_DEPTH)
#define STANDIN_SHADOW_COORDS(index) float4 _ShadowCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_SHADOW(o) o._ShadowCoord = mul(unity_ObjectToWorld, v.vertex);
#define STANDIN_SHADOW(i) i._ShadowCoord.y
#elif defined(SHADOWS_CUBE)
#define STANDIN_SHADOW_COORDS(index) float3 _ShadowCoord : TEXCOORD##index;
#define STANDIN_TRANSFER_SHADOW(o) o._ShadowCoord = mul(unity_ObjectToWorld, v.vertex).xyz - _LightPositionRange.xyz;
#define STANDIN_SHADOW(i) i._ShadowCoord.z
#else
#define STANDIN_SHADOW_COORDS(index)
#define STANDIN_TRANSFER_SHADOW(o)
#define STANDIN_SHADOW(i) 1
#endif

#define UNITY_LIGHTING_COORDS(lightIndex, shadowIndex) STANDIN_LIGHT_COORDS(lightIndex) STANDIN_SHADOW_COORDS(shadowIndex)
#define UNITY_TRANSFER_LIGHTING(o, uv) STANDIN_TRANSFER_LIGHT(o) STANDIN_TRANSFER_SHADOW(o)
#define UNITY_LIGHT_ATTENUATION(attenuation, input, worldPos) float attenuation = STANDIN_ATTENUATION(worldPos) * STANDIN_SHADOW(input)

#endif
