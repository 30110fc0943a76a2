// Motion vectors, for temporal antialiasing and motion blur. The names of the matrices are those of Unity's own pass.
#ifndef ALATE_WING_BUILT_IN_MOTION
#define ALATE_WING_BUILT_IN_MOTION

#include "UnityCG.cginc"

// On phones a texture is read with half the bits unless it is declared so.
sampler2D_float _BakeMap;
sampler2D_float _SkinMap;
float4 _BakeMap_TexelSize, _SkinMap_TexelSize;
float _SkinLast;
#define ALATE_BAKE_SAMPLE(coordinates) tex2Dlod(_BakeMap, float4(coordinates, 0, 0)).xyz
#define ALATE_SKIN_SAMPLE(coordinates) tex2Dlod(_SkinMap, float4(coordinates, 0, 0))
#define ALATE_MOTION
#include "../WingShape.hlsl"
#include "../WingMotion.hlsl"

#if defined(USING_STEREO_MATRICES)
float4x4 _StereoNonJitteredVP[2], _StereoPreviousVP[2];
#define ALATE_PICTURE_NOW _StereoNonJitteredVP[unity_StereoEyeIndex]
#define ALATE_PICTURE_BEFORE _StereoPreviousVP[unity_StereoEyeIndex]
#else
float4x4 _NonJitteredVP, _PreviousVP;
#define ALATE_PICTURE_NOW _NonJitteredVP
#define ALATE_PICTURE_BEFORE _PreviousVP
#endif
float4x4 _PreviousM;
bool _HasLastPositionData, _ForceNoMotion;
float _MotionVectorDepthBias;

Varyings Vertex(Attributes corner)
{
    Varyings v;
    UNITY_INITIALIZE_OUTPUT(Varyings, v);
    UNITY_SETUP_INSTANCE_ID(corner);
    UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(v);
    ALATE_SHAPE_POSITION(corner, position)
    v.position = UnityObjectToClipPos(corner.position);
    v.now = mul(ALATE_PICTURE_NOW, mul(unity_ObjectToWorld, float4(corner.position.xyz, 1)));
    v.before = mul(ALATE_PICTURE_BEFORE, mul(_PreviousM, LastPosition(corner, _HasLastPositionData)));
    #if defined(UNITY_REVERSED_Z)
    v.position.z -= _MotionVectorDepthBias * v.position.w;
    #else
    v.position.z += _MotionVectorDepthBias * v.position.w;
    #endif
    return v;
}

float4 Fragment(Varyings v) : SV_Target
{
    return _ForceNoMotion ? float4(0, 0, 0, 1) : float4(MotionOf(v.now, v.before), 0, 1);
}

#endif
