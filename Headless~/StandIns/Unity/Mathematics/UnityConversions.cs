using System.Runtime.CompilerServices;
using UnityEngine;

namespace Unity.Mathematics;

public partial struct float2
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vector2(float2 v) => new(v.x, v.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float2(Vector2 v) => new(v.x, v.y);
}

public partial struct float3
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vector3(float3 v) => new(v.x, v.y, v.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3(Vector3 v) => new(v.x, v.y, v.z);
}

public partial struct float4
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Vector4(float4 v) => new(v.x, v.y, v.z, v.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4(Vector4 v) => new(v.x, v.y, v.z, v.w);
}

public partial struct @quaternion
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator Quaternion(quaternion q) => new(q.value.x, q.value.y, q.value.z, q.value.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator quaternion(Quaternion q) => new(q.x, q.y, q.z, q.w);
}

public partial struct float4x4
{
    public static implicit operator Matrix4x4(float4x4 m) => new(m.c0, m.c1, m.c2, m.c3);

    public static implicit operator float4x4(Matrix4x4 m) => new(m.GetColumn(0), m.GetColumn(1), m.GetColumn(2), m.GetColumn(3));
}
