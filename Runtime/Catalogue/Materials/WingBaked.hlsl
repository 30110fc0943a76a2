// Wings of baked insects: a texture holds where each vertex is at each frame, normals in its upper half. An instance says which rows are shown, of two loops that are blended,
// and its tint; with ALATE_MOTION also which rows the last picture showed. Needs _BakeMap, _BakeMap_TexelSize and ALATE_BAKE_SAMPLE(coordinates).
#ifndef ALATE_WING_BAKED
#define ALATE_WING_BAKED

#if defined(_BAKED)

UNITY_INSTANCING_BUFFER_START(AlateBaked)
    UNITY_DEFINE_INSTANCED_PROP(float4, _BakeRows)
    UNITY_DEFINE_INSTANCED_PROP(float4, _BakeNextRows)
    UNITY_DEFINE_INSTANCED_PROP(float4, _BakeTint)
UNITY_INSTANCING_BUFFER_END(AlateBaked)

// Rows before and after, and how far the phase lies between them.
float3 AlateBakedLoop(float2 first, float3 rows)
{
    float2 before = first + float2(0, rows.x * _BakeMap_TexelSize.y), after = first + float2(0, rows.y * _BakeMap_TexelSize.y);
    return lerp(ALATE_BAKE_SAMPLE(before), ALATE_BAKE_SAMPLE(after), rows.z);
}

float3 AlateBakedLoops(float2 first, float4 rows, float4 nextRows)
{
    float3 value = AlateBakedLoop(first, rows.xyz);
    if (rows.w > 0)
        value = lerp(value, AlateBakedLoop(first, nextRows.xyz), rows.w);
    return value;
}

float3 AlateBaked(float2 first)
{
    return AlateBakedLoops(
        first, UNITY_ACCESS_INSTANCED_PROP(AlateBaked, _BakeRows), UNITY_ACCESS_INSTANCED_PROP(AlateBaked, _BakeNextRows));
}

#if defined(ALATE_MOTION)

// The last of the next loop's four numbers is 1 where the rows are known.
UNITY_INSTANCING_BUFFER_START(AlateBakedLast)
    UNITY_DEFINE_INSTANCED_PROP(float4, _BakeLastRows)
    UNITY_DEFINE_INSTANCED_PROP(float4, _BakeLastNextRows)
UNITY_INSTANCING_BUFFER_END(AlateBakedLast)

float3 AlateBakedBefore(float2 first, float3 now)
{
    float4 nextRows = UNITY_ACCESS_INSTANCED_PROP(AlateBakedLast, _BakeLastNextRows);
    if (nextRows.w < 0.5)
        return now;
    return AlateBakedLoops(first, UNITY_ACCESS_INSTANCED_PROP(AlateBakedLast, _BakeLastRows), nextRows);
}
#endif

#endif

#endif
