// Depth alone: the depth texture, and depth priming.
#ifndef ALATE_WING_DEPTH
#define ALATE_WING_DEPTH

#include "WingInput.hlsl"

struct Attributes
{
    float4 position : POSITION;
    float2 uv : TEXCOORD0;
    ALATE_SHAPE_INPUT
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 position : SV_POSITION;
    float2 uv : TEXCOORD0;
    UNITY_VERTEX_OUTPUT_STEREO
};

Varyings Vertex(Attributes corner)
{
    Varyings v = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(corner);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
    ALATE_SHAPE_POSITION(corner, position)
    v.position = OnScreen(PlaceOf(corner.position));
    v.uv = TRANSFORM_TEX(corner.uv, _MainTex);
    return v;
}

half4 Fragment(Varyings v) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(v);
    CutMarginAt(v.uv);
    return v.position.z;
}

#endif
