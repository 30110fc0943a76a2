using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct uint2
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator +(uint2 lhs, uint2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator +(uint2 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator +(uint lhs, uint2 rhs) => new(lhs + rhs.x, lhs + rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator -(uint2 lhs, uint2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator -(uint2 lhs, uint rhs) => new(lhs.x - rhs, lhs.y - rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator -(uint lhs, uint2 rhs) => new(lhs - rhs.x, lhs - rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator *(uint2 lhs, uint2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator *(uint2 lhs, uint rhs) => new(lhs.x * rhs, lhs.y * rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator *(uint lhs, uint2 rhs) => new(lhs * rhs.x, lhs * rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator /(uint2 lhs, uint2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator /(uint2 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator /(uint lhs, uint2 rhs) => new(lhs / rhs.x, lhs / rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator %(uint2 lhs, uint2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator %(uint2 lhs, uint rhs) => new(lhs.x % rhs, lhs.y % rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator %(uint lhs, uint2 rhs) => new(lhs % rhs.x, lhs % rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator ~(uint2 val) => new(~val.x, ~val.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator &(uint2 lhs, uint2 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator &(uint2 lhs, uint rhs) => new(lhs.x & rhs, lhs.y & rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator |(uint2 lhs, uint2 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator |(uint2 lhs, uint rhs) => new(lhs.x | rhs, lhs.y | rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator ^(uint2 lhs, uint2 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator ^(uint2 lhs, uint rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator <<(uint2 x, int n) => new(x.x << n, x.y << n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 operator >>(uint2 x, int n) => new(x.x >> n, x.y >> n);
}
