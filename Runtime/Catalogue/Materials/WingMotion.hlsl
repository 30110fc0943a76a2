// Where a vertex was in the last picture, for motion vectors: of living wings by their displacements or their joints, of baked ones by the rows that were shown
// then, and of skinned meshes as Unity tells it. Needs ALATE_MOTION before WingShape.hlsl.
#ifndef ALATE_WING_MOTION
#define ALATE_WING_MOTION

struct Attributes
{
    float4 position : POSITION;

    // Unity's, of skinned meshes; of wings that the graphics card deforms it is found by their joints.
    float3 last : TEXCOORD4;

    // From the last place to this one; 0 where the mesh has none.
    float3 displacement : TEXCOORD5;
    ALATE_SHAPE_INPUT
    UNITY_VERTEX_INPUT_INSTANCE_ID
};

struct Varyings
{
    float4 position : SV_POSITION;

    // In the pictures, without the jitter of antialiasing.
    float4 now : TEXCOORD0;
    float4 before : TEXCOORD1;
    UNITY_VERTEX_OUTPUT_STEREO
};

// isSkinned: whether Unity knows the last place.
float4 LastPosition(Attributes corner, bool isSkinned)
{
    #if defined(_BAKED)
    return float4(AlateBakedBefore(corner.baked, corner.position.xyz), 1);
    #elif defined(_SKINNED)
    return float4(corner.last, 1);
    #else
    return float4((isSkinned ? corner.last : corner.position.xyz) - corner.displacement, 1);
    #endif
}

// In shares of the picture, upwards as its texture counts.
float2 MotionOf(float4 now, float4 before)
{
    float2 motion = 0.5 * (now.xy / now.w - before.xy / before.w);
    #if UNITY_UV_STARTS_AT_TOP
    motion.y = -motion.y;
    #endif
    return motion;
}

#endif
