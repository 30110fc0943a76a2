using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct uint3
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator +(uint3 lhs, uint3 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y, lhs.z + rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator +(uint3 lhs, uint rhs) => new(lhs.x + rhs, lhs.y + rhs, lhs.z + rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator +(uint lhs, uint3 rhs) => new(lhs + rhs.x, lhs + rhs.y, lhs + rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator -(uint3 lhs, uint3 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y, lhs.z - rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator -(uint3 lhs, uint rhs) => new(lhs.x - rhs, lhs.y - rhs, lhs.z - rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator -(uint lhs, uint3 rhs) => new(lhs - rhs.x, lhs - rhs.y, lhs - rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator *(uint3 lhs, uint3 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y, lhs.z * rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator *(uint3 lhs, uint rhs) => new(lhs.x * rhs, lhs.y * rhs, lhs.z * rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator *(uint lhs, uint3 rhs) => new(lhs * rhs.x, lhs * rhs.y, lhs * rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator /(uint3 lhs, uint3 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator /(uint3 lhs, uint rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator /(uint lhs, uint3 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator %(uint3 lhs, uint3 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator %(uint3 lhs, uint rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator %(uint lhs, uint3 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator ~(uint3 val) => new(~val.x, ~val.y, ~val.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator &(uint3 lhs, uint3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator &(uint3 lhs, uint rhs) => new(lhs.x & rhs, lhs.y & rhs, lhs.z & rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator |(uint3 lhs, uint3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator |(uint3 lhs, uint rhs) => new(lhs.x | rhs, lhs.y | rhs, lhs.z | rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator ^(uint3 lhs, uint3 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator ^(uint3 lhs, uint rhs) => new(lhs.x ^ rhs, lhs.y ^ rhs, lhs.z ^ rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator <<(uint3 x, int n) => new(x.x << n, x.y << n, x.z << n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 operator >>(uint3 x, int n) => new(x.x >> n, x.y >> n, x.z >> n);
}
