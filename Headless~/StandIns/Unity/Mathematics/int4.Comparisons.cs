using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct int4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(int4 lhs, int4 rhs) => new(Vector128.LessThan(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(int4 lhs, int rhs) => new(Vector128.LessThan(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(int lhs, int4 rhs) => new(Vector128.LessThan(Vector128.Create(lhs), rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(int4 lhs, int4 rhs) => new(Vector128.LessThanOrEqual(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(int4 lhs, int rhs) => new(Vector128.LessThanOrEqual(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(int lhs, int4 rhs) => new(Vector128.LessThanOrEqual(Vector128.Create(lhs), rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(int4 lhs, int4 rhs) => new(Vector128.GreaterThan(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(int4 lhs, int rhs) => new(Vector128.GreaterThan(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(int lhs, int4 rhs) => new(Vector128.GreaterThan(Vector128.Create(lhs), rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(int4 lhs, int4 rhs) => new(Vector128.GreaterThanOrEqual(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(int4 lhs, int rhs) => new(Vector128.GreaterThanOrEqual(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(int lhs, int4 rhs) => new(Vector128.GreaterThanOrEqual(Vector128.Create(lhs), rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(int4 lhs, int4 rhs) => new(Vector128.Equals(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(int4 lhs, int rhs) => new(Vector128.Equals(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(int lhs, int4 rhs) => new(Vector128.Equals(Vector128.Create(lhs), rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(int4 lhs, int4 rhs) => new(~Vector128.Equals(lhs.V, rhs.V).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(int4 lhs, int rhs) => new(~Vector128.Equals(lhs.V, Vector128.Create(rhs)).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(int lhs, int4 rhs) => new(~Vector128.Equals(Vector128.Create(lhs), rhs.V).AsUInt32());
}
