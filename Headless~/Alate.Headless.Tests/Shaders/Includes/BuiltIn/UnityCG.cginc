// Names and signatures of the built-in pipeline's UnityCG.cginc, as far as Alate's shader uses them. What places a surface before a perspective camera and lights it
// by a sun does so, so that pictures can be drawn with it.
#ifndef STANDIN_UNITY_CG
#define STANDIN_UNITY_CG

#include "../Instancing.hlsl"
#include "../Light.hlsl"

#define sampler2D Texture2D
#define sampler2D_float Texture2D
SamplerState standin_sampler;
#define tex2D(name, uv) name.Sample(standin_sampler, uv)
#define tex2Dlod(name, place) name.SampleLevel(standin_sampler, (place).xy, (place).w)
#define UNITY_INITIALIZE_OUTPUT(type, name) name = (type)0;
#define TRANSFORM_TEX(uv, name) ((uv).xy * name##_ST.xy + name##_ST.zw)

#if defined(UNITY_STEREO_INSTANCING_ENABLED)
#define USING_STEREO_MATRICES
#endif
#define UNITY_REVERSED_Z 1
#define UNITY_UV_STARTS_AT_TOP 1

float4x4 unity_ObjectToWorld, unity_MatrixVP;
float4 _WorldSpaceLightPos0, _LightPositionRange;
float3 _WorldSpaceCameraPos;
half4 unity_FogColor;

float4 UnityObjectToClipPos(float3 pos) { return mul(unity_MatrixVP, mul(unity_ObjectToWorld, float4(pos, 1))); }
float4 UnityObjectToClipPos(float4 pos) { return UnityObjectToClipPos(pos.xyz); }
float3 UnityObjectToWorldNormal(float3 norm) { return normalize(StandinNormal((float3x3)unity_ObjectToWorld, norm)); }
float3 UnityWorldSpaceLightDir(float3 worldPos) { return _WorldSpaceLightPos0.xyz - worldPos * _WorldSpaceLightPos0.w; }
float3 UnityWorldSpaceViewDir(float3 worldPos) { return _WorldSpaceCameraPos - worldPos; }
half3 ShadeSH9(half4 normal) { return StandinAmbient(normal.xyz); }
half3 GammaToLinearSpace(half3 sRGB) { return StandinLinear(sRGB); }
float4 ComputeScreenPos(float4 pos) { return pos; }

#if defined(FOG_LINEAR) || defined(FOG_EXP) || defined(FOG_EXP2)
#define UNITY_FOG_COORDS(index) float fogCoord : TEXCOORD##index;
#define UNITY_TRANSFER_FOG(o, outpos) o.fogCoord = (outpos).z
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol) col.rgb = lerp((fogCol).rgb, (col).rgb, saturate(coord))
#else
#define UNITY_FOG_COORDS(index)
#define UNITY_TRANSFER_FOG(o, outpos)
#define UNITY_APPLY_FOG_COLOR(coord, col, fogCol)
#endif

float4 UnityClipSpaceShadowCasterPos(float4 vertex, float3 normal) { return UnityObjectToClipPos(vertex.xyz + normal); }

#if defined(SHADOWS_CUBE)
#define V2F_SHADOW_CASTER float3 vec : TEXCOORD0; float4 pos : SV_POSITION
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) o.vec = mul(unity_ObjectToWorld, v.vertex).xyz - _LightPositionRange.xyz; o.pos = UnityObjectToClipPos(v.vertex);
#define SHADOW_CASTER_FRAGMENT(i) return length(i.vec) * _LightPositionRange.w;
#else
#define V2F_SHADOW_CASTER float4 pos : SV_POSITION
#define TRANSFER_SHADOW_CASTER_NORMALOFFSET(o) o.pos = UnityClipSpaceShadowCasterPos(v.vertex, v.normal);
#define SHADOW_CASTER_FRAGMENT(i) return 0;
#endif

#endif
