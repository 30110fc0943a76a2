using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public partial struct float3
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <(float3 lhs, float3 rhs) => new(lhs.x < rhs.x, lhs.y < rhs.y, lhs.z < rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <(float3 lhs, float rhs) => new(lhs.x < rhs, lhs.y < rhs, lhs.z < rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <(float lhs, float3 rhs) => new(lhs < rhs.x, lhs < rhs.y, lhs < rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <=(float3 lhs, float3 rhs) => new(lhs.x <= rhs.x, lhs.y <= rhs.y, lhs.z <= rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <=(float3 lhs, float rhs) => new(lhs.x <= rhs, lhs.y <= rhs, lhs.z <= rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator <=(float lhs, float3 rhs) => new(lhs <= rhs.x, lhs <= rhs.y, lhs <= rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >(float3 lhs, float3 rhs) => new(lhs.x > rhs.x, lhs.y > rhs.y, lhs.z > rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >(float3 lhs, float rhs) => new(lhs.x > rhs, lhs.y > rhs, lhs.z > rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >(float lhs, float3 rhs) => new(lhs > rhs.x, lhs > rhs.y, lhs > rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >=(float3 lhs, float3 rhs) => new(lhs.x >= rhs.x, lhs.y >= rhs.y, lhs.z >= rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >=(float3 lhs, float rhs) => new(lhs.x >= rhs, lhs.y >= rhs, lhs.z >= rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator >=(float lhs, float3 rhs) => new(lhs >= rhs.x, lhs >= rhs.y, lhs >= rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator ==(float3 lhs, float3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator ==(float3 lhs, float rhs) => new(lhs.x == rhs, lhs.y == rhs, lhs.z == rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator ==(float lhs, float3 rhs) => new(lhs == rhs.x, lhs == rhs.y, lhs == rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator !=(float3 lhs, float3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator !=(float3 lhs, float rhs) => new(lhs.x != rhs, lhs.y != rhs, lhs.z != rhs);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator !=(float lhs, float3 rhs) => new(lhs != rhs.x, lhs != rhs.y, lhs != rhs.z);
}
