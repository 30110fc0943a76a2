using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct float4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(float4 lhs, float4 rhs) =>
        new(Vector128.LessThan(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(float4 lhs, float rhs) =>
        new(Vector128.LessThan(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(float lhs, float4 rhs) =>
        new(Vector128.LessThan(Vector128.Create(lhs), rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(float4 lhs, float4 rhs) =>
        new(Vector128.LessThanOrEqual(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(float4 lhs, float rhs) =>
        new(Vector128.LessThanOrEqual(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(float lhs, float4 rhs) =>
        new(Vector128.LessThanOrEqual(Vector128.Create(lhs), rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(float4 lhs, float4 rhs) =>
        new(Vector128.GreaterThan(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(float4 lhs, float rhs) =>
        new(Vector128.GreaterThan(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(float lhs, float4 rhs) =>
        new(Vector128.GreaterThan(Vector128.Create(lhs), rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(float4 lhs, float4 rhs) =>
        new(Vector128.GreaterThanOrEqual(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(float4 lhs, float rhs) =>
        new(Vector128.GreaterThanOrEqual(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(float lhs, float4 rhs) =>
        new(Vector128.GreaterThanOrEqual(Vector128.Create(lhs), rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(float4 lhs, float4 rhs) =>
        new(Vector128.Equals(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(float4 lhs, float rhs) =>
        new(Vector128.Equals(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(float lhs, float4 rhs) =>
        new(Vector128.Equals(Vector128.Create(lhs), rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(float4 lhs, float4 rhs) =>
        new(~Vector128.Equals(lhs.lanes, rhs.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(float4 lhs, float rhs) =>
        new(~Vector128.Equals(lhs.lanes, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(float lhs, float4 rhs) =>
        new(~Vector128.Equals(Vector128.Create(lhs), rhs.lanes).AsUInt32());
}
