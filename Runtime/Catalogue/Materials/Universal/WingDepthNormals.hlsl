// Depth and normals: ambient occlusion, and depth priming where normals are asked for. A deferred renderer draws it for shaders that it draws forward.
#ifndef ALATE_WING_DEPTH_NORMALS
#define ALATE_WING_DEPTH_NORMALS

#include "WingInput.hlsl"
#include "Packages/com.unity.render-pipelines.core/ShaderLibrary/Packing.hlsl"

struct Attributes
{
    float4 position : POSITION;
    float3 normal : NORMAL;
    float2 uv : TEXCOORD0;
    ALATE_SHAPE_INPUT
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 position : SV_POSITION;
    float3 normal : TEXCOORD0;
    float3 place : TEXCOORD1;
    float2 uv : TEXCOORD2;
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings Vertex(Attributes corner)
{
    Varyings v = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(corner);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
    ALATE_SHAPE_POSITION(corner, position)
    ALATE_SHAPE_NORMAL(corner)
    v.place = PlaceOf(corner.position);
    v.position = OnScreen(v.place);
    v.normal = TransformObjectToWorldNormal(corner.normal);
    v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
    return v;
}

half4 Fragment(Varyings v) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(v);
    CutMarginAt(v.uv);
    float3 normal = FacingNormal(v.normal, GetWorldSpaceNormalizeViewDir(v.place));
    #if defined(_GBUFFER_NORMALS_OCT)

    // A deferred renderer with accurate normals keeps them folded into an octahedron, two numbers of 12 bits in three bytes.
    float2 folded = saturate(0.5 * PackNormalOctQuadEncode(normal) + 0.5);
    return half4(PackFloat2To888(folded), 0);
    #else
    return half4(normal, 0);
    #endif
}

#endif
