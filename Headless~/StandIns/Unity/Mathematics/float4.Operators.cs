using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct float4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator +(float4 lhs, float4 rhs) => new() { lanes = lhs.lanes + rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator +(float4 lhs, float rhs) => new() { lanes = lhs.lanes + Vector128.Create(rhs) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator +(float lhs, float4 rhs) => new() { lanes = Vector128.Create(lhs) + rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator -(float4 lhs, float4 rhs) => new() { lanes = lhs.lanes - rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator -(float4 lhs, float rhs) => new() { lanes = lhs.lanes - Vector128.Create(rhs) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator -(float lhs, float4 rhs) => new() { lanes = Vector128.Create(lhs) - rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator *(float4 lhs, float4 rhs) => new() { lanes = lhs.lanes * rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator *(float4 lhs, float rhs) => new() { lanes = lhs.lanes * rhs };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator *(float lhs, float4 rhs) => new() { lanes = lhs * rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator /(float4 lhs, float4 rhs) => new() { lanes = lhs.lanes / rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator /(float4 lhs, float rhs) => new() { lanes = lhs.lanes / Vector128.Create(rhs) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator /(float lhs, float4 rhs) => new() { lanes = Vector128.Create(lhs) / rhs.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator %(float4 lhs, float4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator %(float4 lhs, float rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator %(float lhs, float4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator -(float4 val) => new() { lanes = -val.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 operator +(float4 val) => val;
}
