// What the passes of Alate/Wing share in the built-in pipeline.
#ifndef ALATE_WING_BUILT_IN
#define ALATE_WING_BUILT_IN

#include "UnityCG.cginc"
#include "Lighting.cginc"
#include "AutoLight.cginc"
#include "../WingLight.hlsl"

sampler2D _MainTex;
float4 _MainTex_ST;
half4 _Color, _Underside;
half _VertexColours, _Through, _Gloss, _Shine, _Cull, _Translucent;

// On phones a texture is read with half the bits unless it is declared so.
sampler2D_float _BakeMap;
sampler2D_float _SkinMap;
float4 _BakeMap_TexelSize, _SkinMap_TexelSize;
float _SkinLast;
#define ALATE_BAKE_SAMPLE(coordinates) tex2Dlod(_BakeMap, float4(coordinates, 0, 0)).xyz
#define ALATE_SKIN_SAMPLE(coordinates) tex2Dlod(_SkinMap, float4(coordinates, 0, 0))
#include "../WingShape.hlsl"

struct Attributes
{
    float4 vertex : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
    half4 colour : COLOR;
    ALATE_SHAPE_INPUT
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 pos : SV_POSITION;
    float2 uv : TEXCOORD0;
    float3 normal : TEXCOORD1;
    float3 place : TEXCOORD2;
    half4 colour : TEXCOORD3;
    UNITY_FOG_COORDS(4)
    UNITY_LIGHTING_COORDS(5, 6)
    UNITY_VERTEX_INPUT_INSTANCE_ID
    UNITY_VERTEX_OUTPUT_STEREO
};

half4 Paint(half4 vertexColour, float2 uv)
{
    #ifndef UNITY_COLORSPACE_GAMMA
    vertexColour.rgb = GammaToLinearSpace(vertexColour.rgb);
    #endif
    half4 paint = tex2D(_MainTex, uv) * _Color * lerp(half4(1, 1, 1, 1), vertexColour, _VertexColours);
    #if defined(_CUT)
    paint.a = AlateCutMargin(paint.a);
    #else
    paint.a = lerp(1, paint.a, _Translucent);
    #endif
    return paint;
}

Varyings ToVaryings(Attributes v)
{
    Varyings o;
    UNITY_INITIALIZE_OUTPUT(Varyings, o);
    UNITY_SETUP_INSTANCE_ID(v);
    UNITY_TRANSFER_INSTANCE_ID(v, o);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(o);
    ALATE_SHAPE_POSITION(v, vertex)
    ALATE_SHAPE_NORMAL(v)
    o.pos = UnityObjectToClipPos(v.vertex);
    o.place = mul(unity_ObjectToWorld, v.vertex).xyz;
    o.normal = UnityObjectToWorldNormal(v.normal);
    o.uv = TRANSFORM_TEX(v.uv, _MainTex);
    o.colour = v.colour;
    UNITY_TRANSFER_FOG(o, o.pos);
    UNITY_TRANSFER_LIGHTING(o, v.uv);
    return o;
}

// Of the one light that the pass is for.
float3 LightOf(Varyings i, half3 colour, float3 normal, float3 toEye)
{
    UNITY_LIGHT_ATTENUATION(share, i, i.place);
    float3 toLight = normalize(UnityWorldSpaceLightDir(i.place));
    return AlateWingLight(colour, normal, toEye, toLight, _LightColor0.rgb * share, _Through, _Gloss, _Shine);
}

#endif
