// Motion vectors, for temporal antialiasing and motion blur.
#ifndef ALATE_WING_UNIVERSAL_MOTION
#define ALATE_WING_UNIVERSAL_MOTION

#define ALATE_MOTION
#include "WingInput.hlsl"
#include "../WingMotion.hlsl"

Varyings Vertex(Attributes corner)
{
    Varyings v = (Varyings)0;
    UNITY_SETUP_INSTANCE_ID(corner);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
    ALATE_SHAPE_POSITION(corner, position)
    v.position = OnScreen(PlaceOf(corner.position));
    v.now = mul(_NonJitteredViewProjMatrix, mul(UNITY_MATRIX_M, float4(corner.position.xyz, 1)));
    v.before = mul(_PrevViewProjMatrix, mul(UNITY_PREV_MATRIX_M, LastPosition(corner, unity_MotionVectorsParams.x == 1)));
    #if defined(ALATE_MOTION_BIAS)

    // These versions compare with a depth of their own.
    #if UNITY_REVERSED_Z
    v.position.z -= unity_MotionVectorsParams.z * v.position.w;
    #else
    v.position.z += unity_MotionVectorsParams.z * v.position.w;
    #endif
    #endif
    return v;
}

float4 Fragment(Varyings v) : SV_Target
{
    UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(v);

    // y is 0 where the renderer is to have no motion.
    return unity_MotionVectorsParams.y == 0 ? float4(0, 0, 0, 0) : float4(MotionOf(v.now, v.before), 0, 0);
}

#endif
