using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int asint(float x) => BitConverter.SingleToInt32Bits(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 asint(float2 x) => new(asint(x.x), asint(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 asint(float3 x) => new(asint(x.x), asint(x.y), asint(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 asint(float4 x) => new(x.lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint asuint(float x) => BitConverter.SingleToUInt32Bits(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 asuint(float2 x) => new(asuint(x.x), asuint(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 asuint(float3 x) => new(asuint(x.x), asuint(x.y), asuint(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 asuint(float4 x) => new(x.lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 f32tof16(float4 x) => new(f32tof16(x.x), f32tof16(x.y), f32tof16(x.z), f32tof16(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint f32tof16(float x) => BitConverter.HalfToUInt16Bits((Half)x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float f16tof32(uint x) => (float)BitConverter.UInt16BitsToHalf((ushort)x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float asfloat(int x) => BitConverter.Int32BitsToSingle(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 asfloat(int2 x) => new(asfloat(x.x), asfloat(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 asfloat(int3 x) => new(asfloat(x.x), asfloat(x.y), asfloat(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 asfloat(int4 x) => new(x.lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float asfloat(uint x) => BitConverter.UInt32BitsToSingle(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 asfloat(uint2 x) => new(asfloat(x.x), asfloat(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 asfloat(uint3 x) => new(asfloat(x.x), asfloat(x.y), asfloat(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 asfloat(uint4 x) => new(x.lanes);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static long aslong(double x) => BitConverter.DoubleToInt64Bits(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double asdouble(long x) => BitConverter.Int64BitsToDouble(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(float2 v) => hash(asuint(v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(int2 v) => hash((uint2)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(uint2 v) => (v.x * 0x9E3779B1u) ^ (v.y * 0x85EBCA77u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(float3 v) => hash(asuint(v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(int3 v) => hash((uint3)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(uint3 v) => (v.x * 0x9E3779B1u) ^ (v.y * 0x85EBCA77u) ^ (v.z * 0xC2B2AE3Du);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(float4 v) => hash(asuint(v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(int4 v) => hash((uint4)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static uint hash(uint4 v) => (v.x * 0x9E3779B1u) ^ (v.y * 0x85EBCA77u) ^ (v.z * 0xC2B2AE3Du) ^ (v.w * 0x27D4EB2Fu);
}
