using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct int2
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <(int2 lhs, int2 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <(int2 lhs, int rhs) => new(lhs.x < rhs, lhs.y < rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <(int lhs, int2 rhs) => new(lhs < rhs.x, lhs < rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <=(int2 lhs, int2 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <=(int2 lhs, int rhs) => new(lhs.x <= rhs, lhs.y <= rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator <=(int lhs, int2 rhs) => new(lhs <= rhs.x, lhs <= rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >(int2 lhs, int2 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >(int2 lhs, int rhs) => new(lhs.x > rhs, lhs.y > rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >(int lhs, int2 rhs) => new(lhs > rhs.x, lhs > rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >=(int2 lhs, int2 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >=(int2 lhs, int rhs) => new(lhs.x >= rhs, lhs.y >= rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator >=(int lhs, int2 rhs) => new(lhs >= rhs.x, lhs >= rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator ==(int2 lhs, int2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator ==(int2 lhs, int rhs) => new(lhs.x == rhs, lhs.y == rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator ==(int lhs, int2 rhs) => new(lhs == rhs.x, lhs == rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator !=(int2 lhs, int2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator !=(int2 lhs, int rhs) => new(lhs.x != rhs, lhs.y != rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator !=(int lhs, int2 rhs) => new(lhs != rhs.x, lhs != rhs.y);
}
