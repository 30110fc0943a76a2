using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

// As in Unity, * and / work element by element; math.mul is the matrix product.
public partial struct float4x4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator +(float4x4 lhs, float4x4 rhs) =>
        new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2, lhs.c3 + rhs.c3);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator -(float4x4 lhs, float4x4 rhs) =>
        new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2, lhs.c3 - rhs.c3);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator -(float4x4 val) => new(-val.c0, -val.c1, -val.c2, -val.c3);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator *(float4x4 lhs, float4x4 rhs) =>
        new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2, lhs.c3 * rhs.c3);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator *(float4x4 lhs, float rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs, lhs.c3 * rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator *(float lhs, float4x4 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2, lhs * rhs.c3);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 operator /(float4x4 lhs, float rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs, lhs.c3 / rhs);
}
