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
