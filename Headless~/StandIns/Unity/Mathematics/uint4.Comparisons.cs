using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct uint4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(uint4 lhs, uint4 rhs) => new(Vector128.LessThan(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(uint4 lhs, uint rhs) => new(Vector128.LessThan(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <(uint lhs, uint4 rhs) => new(Vector128.LessThan(Vector128.Create(lhs), rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(uint4 lhs, uint4 rhs) => new(Vector128.LessThanOrEqual(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(uint4 lhs, uint rhs) => new(Vector128.LessThanOrEqual(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator <=(uint lhs, uint4 rhs) => new(Vector128.LessThanOrEqual(Vector128.Create(lhs), rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(uint4 lhs, uint4 rhs) => new(Vector128.GreaterThan(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(uint4 lhs, uint rhs) => new(Vector128.GreaterThan(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >(uint lhs, uint4 rhs) => new(Vector128.GreaterThan(Vector128.Create(lhs), rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(uint4 lhs, uint4 rhs) => new(Vector128.GreaterThanOrEqual(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(uint4 lhs, uint rhs) => new(Vector128.GreaterThanOrEqual(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator >=(uint lhs, uint4 rhs) => new(Vector128.GreaterThanOrEqual(Vector128.Create(lhs), rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(uint4 lhs, uint4 rhs) => new(Vector128.Equals(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(uint4 lhs, uint rhs) => new(Vector128.Equals(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(uint lhs, uint4 rhs) => new(Vector128.Equals(Vector128.Create(lhs), rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(uint4 lhs, uint4 rhs) => new(~Vector128.Equals(lhs.V, rhs.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(uint4 lhs, uint rhs) => new(~Vector128.Equals(lhs.V, Vector128.Create(rhs)));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(uint lhs, uint4 rhs) => new(~Vector128.Equals(Vector128.Create(lhs), rhs.V));
}
