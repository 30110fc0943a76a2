using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    private const float k_NlerpBelow = 0.9995f;

    public static quaternion quaternion(float x, float y, float z, float w) => new(x, y, z, w);

    public static quaternion quaternion(float4 value) => new(value);

    public static quaternion quaternion(float3x3 m) => new(m);

    public static quaternion quaternion(float4x4 m) => new(m);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion conjugate(quaternion q) => new(q.value * new float4(-1f, -1f, -1f, 1f));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion inverse(quaternion q) => new(rcp(dot(q.value, q.value)) * q.value * new float4(-1f, -1f, -1f, 1f));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float dot(quaternion a, quaternion b) => dot(a.value, b.value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float length(quaternion q) => sqrt(dot(q.value, q.value));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lengthsq(quaternion q) => dot(q.value, q.value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion normalize(quaternion q) => new(rsqrt(dot(q.value, q.value)) * q.value);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion normalizesafe(quaternion q) => normalizesafe(q, new quaternion(0f, 0f, 0f, 1f));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion normalizesafe(quaternion q, quaternion defaultvalue) => new(normalizesafe(q.value, defaultvalue.value));

    /// <summary>The rotation b, then the rotation a.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static quaternion mul(quaternion a, quaternion b)
    {
        float4 p = a.value, q = b.value;
        return new quaternion(p.wwww * q + (p.xyzx * q.wwwx + p.yzxy * q.zxyy) * new float4(1f, 1f, 1f, -1f) - p.zxyz * q.yzxz);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 mul(quaternion q, float3 v)
    {
        float3 t = 2f * cross(q.value.xyz, v);
        return v + q.value.w * t + cross(q.value.xyz, t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 rotate(quaternion q, float3 v) => mul(q, v);

    public static float3 forward(quaternion q) => mul(q, new float3(0f, 0f, 1f));

    /// <summary>The shorter way, normalised.</summary>
    public static quaternion nlerp(quaternion q1, quaternion q2, float t)
    {
        float4 end = dot(q1, q2) < 0f ? -q2.value : q2.value;
        return normalize(new quaternion(lerp(q1.value, end, t)));
    }

    /// <summary>The shorter way at constant angular speed.</summary>
    public static quaternion slerp(quaternion q1, quaternion q2, float t)
    {
        float cosine = dot(q1, q2);
        if (cosine < 0f)
        {
            cosine = -cosine;
            q2.value = -q2.value;
        }

        if (cosine >= k_NlerpBelow)
            return nlerp(q1, q2, t);
        float angle = acos(cosine);
        float scale = rsqrt(1f - cosine * cosine);
        return new quaternion(q1.value * (sin(angle * (1f - t)) * scale) + q2.value * (sin(angle * t) * scale));
    }
}
