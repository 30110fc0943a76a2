using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

// As in Unity, * and / work element by element; math.mul is the matrix product.
public partial struct float3x3
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator +(float3x3 lhs, float3x3 rhs) => new(lhs.c0 + rhs.c0, lhs.c1 + rhs.c1, lhs.c2 + rhs.c2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator -(float3x3 lhs, float3x3 rhs) => new(lhs.c0 - rhs.c0, lhs.c1 - rhs.c1, lhs.c2 - rhs.c2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator -(float3x3 val) => new(-val.c0, -val.c1, -val.c2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator *(float3x3 lhs, float3x3 rhs) => new(lhs.c0 * rhs.c0, lhs.c1 * rhs.c1, lhs.c2 * rhs.c2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator *(float3x3 lhs, float rhs) => new(lhs.c0 * rhs, lhs.c1 * rhs, lhs.c2 * rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator *(float lhs, float3x3 rhs) => new(lhs * rhs.c0, lhs * rhs.c1, lhs * rhs.c2);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 operator /(float3x3 lhs, float rhs) => new(lhs.c0 / rhs, lhs.c1 / rhs, lhs.c2 / rhs);
}
