using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    public static float3x3 float3x3(float3 c0, float3 c1, float3 c2) => new(c0, c1, c2);

    public static float3x3 float3x3(quaternion rotation) => new(rotation);

    public static float4x4 float4x4(float4 c0, float4 c1, float4 c2, float4 c3) => new(c0, c1, c2, c3);

    public static float4x4 float4x4(quaternion rotation, float3 translation) => new(rotation, translation);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 mul(float3x3 a, float3 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 mul(float3 a, float3x3 b) => new(dot(a, b.c0), dot(a, b.c1), dot(a, b.c2));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 mul(float3x3 a, float3x3 b) => new(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 mul(float4x4 a, float4 b) => a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3 * b.w;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4x4 mul(float4x4 a, float4x4 b) => new(mul(a, b.c0), mul(a, b.c1), mul(a, b.c2), mul(a, b.c3));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 transform(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z + a.c3).xyz;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 rotate(float4x4 a, float3 b) => (a.c0 * b.x + a.c1 * b.y + a.c2 * b.z).xyz;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3x3 transpose(float3x3 v) =>
        new(new float3(v.c0.x, v.c1.x, v.c2.x), new float3(v.c0.y, v.c1.y, v.c2.y), new float3(v.c0.z, v.c1.z, v.c2.z));

    public static float determinant(float3x3 m) => dot(m.c0, cross(m.c1, m.c2));

    public static float3x3 inverse(float3x3 m)
    {
        float3 r0 = cross(m.c1, m.c2), r1 = cross(m.c2, m.c0), r2 = cross(m.c0, m.c1);
        return transpose(new float3x3(r0, r1, r2)) * rcp(dot(m.c0, r0));
    }

    public static float determinant(float4x4 m)
    {
        float3 a = m.c0.xyz, b = m.c1.xyz, c = m.c2.xyz, d = m.c3.xyz;
        float3 s = cross(a, b), t = cross(c, d), u = a * m.c1.w - b * m.c0.w, v = c * m.c3.w - d * m.c2.w;
        return dot(s, v) + dot(t, u);
    }

    // After Lengyel, Foundations of Game Engine Development 1, Listing 1.11: in terms of the columns' cross products.
    public static float4x4 inverse(float4x4 m)
    {
        float3 a = m.c0.xyz, b = m.c1.xyz, c = m.c2.xyz, d = m.c3.xyz;
        float x = m.c0.w, y = m.c1.w, z = m.c2.w, w = m.c3.w;
        float scale = rcp(determinant(m));
        float3 s = cross(a, b) * scale, t = cross(c, d) * scale, u = (a * y - b * x) * scale, v = (c * w - d * z) * scale;
        float4 r0 = new(cross(b, v) + t * y, -dot(b, t)), r1 = new(cross(v, a) - t * x, dot(a, t));
        float4 r2 = new(cross(d, u) + s * w, -dot(d, s)), r3 = new(cross(u, c) - s * z, dot(c, s));
        return transpose(new float4x4(r0, r1, r2, r3));
    }
}
