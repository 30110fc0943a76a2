using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct float2
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator +(float2 lhs, float2 rhs) => new(lhs.x + rhs.x, lhs.y + rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator +(float2 lhs, float rhs) => new(lhs.x + rhs, lhs.y + rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator +(float lhs, float2 rhs) => new(lhs + rhs.x, lhs + rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator -(float2 lhs, float2 rhs) => new(lhs.x - rhs.x, lhs.y - rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator -(float2 lhs, float rhs) => new(lhs.x - rhs, lhs.y - rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator -(float lhs, float2 rhs) => new(lhs - rhs.x, lhs - rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator *(float2 lhs, float2 rhs) => new(lhs.x * rhs.x, lhs.y * rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator *(float2 lhs, float rhs) => new(lhs.x * rhs, lhs.y * rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator *(float lhs, float2 rhs) => new(lhs * rhs.x, lhs * rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator /(float2 lhs, float2 rhs) => new(lhs.x / rhs.x, lhs.y / rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator /(float2 lhs, float rhs) => new(lhs.x / rhs, lhs.y / rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator /(float lhs, float2 rhs) => new(lhs / rhs.x, lhs / rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator %(float2 lhs, float2 rhs) => new(lhs.x % rhs.x, lhs.y % rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator %(float2 lhs, float rhs) => new(lhs.x % rhs, lhs.y % rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator %(float lhs, float2 rhs) => new(lhs % rhs.x, lhs % rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator -(float2 val) => new(-val.x, -val.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 operator +(float2 val) => val;
}
