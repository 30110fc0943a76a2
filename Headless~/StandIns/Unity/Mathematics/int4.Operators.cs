using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public partial struct int4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator +(int4 lhs, int4 rhs) => new(lhs.V + rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator +(int4 lhs, int rhs) => new(lhs.V + Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator +(int lhs, int4 rhs) => new(Vector128.Create(lhs) + rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator -(int4 lhs, int4 rhs) => new(lhs.V - rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator -(int4 lhs, int rhs) => new(lhs.V - Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator -(int lhs, int4 rhs) => new(Vector128.Create(lhs) - rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator *(int4 lhs, int4 rhs) => new(lhs.V * rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator *(int4 lhs, int rhs) => new(lhs.V * Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator *(int lhs, int4 rhs) => new(Vector128.Create(lhs) * rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator /(int4 lhs, int4 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y, lhs.z / rhs.z, lhs.w / rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator /(int4 lhs, int rhs) => new(lhs.x / rhs, lhs.y / rhs, lhs.z / rhs, lhs.w / rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator /(int lhs, int4 rhs) => new(lhs / rhs.x, lhs / rhs.y, lhs / rhs.z, lhs / rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator %(int4 lhs, int4 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y, lhs.z % rhs.z, lhs.w % rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator %(int4 lhs, int rhs) => new(lhs.x % rhs, lhs.y % rhs, lhs.z % rhs, lhs.w % rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator %(int lhs, int4 rhs) => new(lhs % rhs.x, lhs % rhs.y, lhs % rhs.z, lhs % rhs.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator -(int4 val) => new(-val.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator ~(int4 val) => new(~val.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator &(int4 lhs, int4 rhs) => new(lhs.V & rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator &(int4 lhs, int rhs) => new(lhs.V & Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator |(int4 lhs, int4 rhs) => new(lhs.V | rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator |(int4 lhs, int rhs) => new(lhs.V | Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator ^(int4 lhs, int4 rhs) => new(lhs.V ^ rhs.V);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator ^(int4 lhs, int rhs) => new(lhs.V ^ Vector128.Create(rhs));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator <<(int4 x, int n) => new(x.V << n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 operator >>(int4 x, int n) => new(x.V >> n);
}
