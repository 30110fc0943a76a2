// What Unity's instancing macros add to structures, in both kinds of pipelines. Members exist in the variants that have them there.
#ifndef STANDIN_INSTANCING
#define STANDIN_INSTANCING

#if defined(INSTANCING_ON) || defined(UNITY_STEREO_INSTANCING_ENABLED)
static uint unity_InstanceID;
#define UNITY_VERTEX_INPUT_INSTANCE_ID uint instanceID : INSTANCE0;
#define UNITY_SETUP_INSTANCE_ID(input) unity_InstanceID = input.instanceID;
#define UNITY_TRANSFER_INSTANCE_ID(input, output) output.instanceID = input.instanceID
#else
#define UNITY_VERTEX_INPUT_INSTANCE_ID
#define UNITY_SETUP_INSTANCE_ID(input)
#define UNITY_TRANSFER_INSTANCE_ID(input, output)
#endif

#if defined(INSTANCING_ON)
#define UNITY_INSTANCING_BUFFER_START(name) cbuffer UnityInstancing_##name { struct name##Members {
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_INSTANCING_BUFFER_END(name) } name##Array[2]; };
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) buffer##Array[unity_InstanceID].name
#else
#define UNITY_INSTANCING_BUFFER_START(name)
#define UNITY_DEFINE_INSTANCED_PROP(type, name) type name;
#define UNITY_INSTANCING_BUFFER_END(name)
#define UNITY_ACCESS_INSTANCED_PROP(buffer, name) name
#endif

#if defined(UNITY_STEREO_INSTANCING_ENABLED)
static uint unity_StereoEyeIndex;
#define UNITY_VERTEX_OUTPUT_STEREO uint stereoEye : STEREO0;
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output) output.stereoEye = unity_StereoEyeIndex
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input) unity_StereoEyeIndex = input.stereoEye;
#else
#define UNITY_VERTEX_OUTPUT_STEREO
#define UNITY_INITIALIZE_VERTEX_OUTPUT_STEREO(output)
#define UNITY_SETUP_STEREO_EYE_INDEX_POST_VERTEX(input)
#endif

#endif
