using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 float2(float x, float y) => new(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 float2(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 float3(float x, float y, float z) => new(x, y, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 float3(float x, float2 yz) => new(x, yz);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 float3(float2 xy, float z) => new(xy, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 float3(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float x, float y, float z, float w) => new(x, y, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float x, float y, float2 zw) => new(x, y, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float x, float2 yz, float w) => new(x, yz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float x, float3 yzw) => new(x, yzw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float2 xy, float z, float w) => new(xy, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float2 xy, float2 zw) => new(xy, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float3 xyz, float w) => new(xyz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 float4(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 int2(int x, int y) => new(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 int2(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 int3(int x, int y, int z) => new(x, y, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 int3(int x, int2 yz) => new(x, yz);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 int3(int2 xy, int z) => new(xy, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 int3(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int x, int y, int z, int w) => new(x, y, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int x, int y, int2 zw) => new(x, y, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int x, int2 yz, int w) => new(x, yz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int x, int3 yzw) => new(x, yzw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int2 xy, int z, int w) => new(xy, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int2 xy, int2 zw) => new(xy, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int3 xyz, int w) => new(xyz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 int4(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 uint2(uint x, uint y) => new(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 uint2(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 uint3(uint x, uint y, uint z) => new(x, y, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 uint3(uint x, uint2 yz) => new(x, yz);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 uint3(uint2 xy, uint z) => new(xy, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 uint3(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint x, uint y, uint z, uint w) => new(x, y, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint x, uint y, uint2 zw) => new(x, y, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint x, uint2 yz, uint w) => new(x, yz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint x, uint3 yzw) => new(x, yzw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint2 xy, uint z, uint w) => new(xy, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint2 xy, uint2 zw) => new(xy, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint3 xyz, uint w) => new(xyz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 uint4(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 bool2(bool x, bool y) => new(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 bool2(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 bool3(bool x, bool y, bool z) => new(x, y, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 bool3(bool x, bool2 yz) => new(x, yz);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 bool3(bool2 xy, bool z) => new(xy, z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 bool3(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool x, bool y, bool z, bool w) => new(x, y, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool x, bool y, bool2 zw) => new(x, y, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool x, bool2 yz, bool w) => new(x, yz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool x, bool3 yzw) => new(x, yzw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool2 xy, bool z, bool w) => new(xy, z, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool2 xy, bool2 zw) => new(xy, zw);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool3 xyz, bool w) => new(xyz, w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 bool4(bool v) => new(v);
}
