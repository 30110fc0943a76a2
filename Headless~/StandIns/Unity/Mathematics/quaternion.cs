using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>A rotation, or any quaternion: value.xyz is the vector part, value.w the scalar part.</summary>
public partial struct @quaternion : IEquatable<quaternion>, IFormattable
{
    public float4 value;

    public static readonly quaternion identity = new(0f, 0f, 0f, 1f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public quaternion(float x, float y, float z, float w)
    {
        value = new float4(x, y, z, w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public quaternion(float4 value)
    {
        this.value = value;
    }

    /// <summary>From an orthonormal matrix.</summary>
    public quaternion(float3x3 m)
    {
        float3 u = m.c0, v = m.c1, w = m.c2;
        float4 squares = new(u.x - v.y - w.z, v.y - u.x - w.z, w.z - u.x - v.y, u.x + v.y + w.z);
        float largest = math.cmax(squares);
        float root = math.sqrt(largest + 1f);
        float half = 0.5f / root;
        if (largest == squares.w)
            value = new float4((v.z - w.y) * half, (w.x - u.z) * half, (u.y - v.x) * half, 0.5f * root);
        else if (largest == squares.x)
            value = new float4(0.5f * root, (u.y + v.x) * half, (w.x + u.z) * half, (v.z - w.y) * half);
        else if (largest == squares.y)
            value = new float4((u.y + v.x) * half, 0.5f * root, (v.z + w.y) * half, (w.x - u.z) * half);
        else
            value = new float4((w.x + u.z) * half, (v.z + w.y) * half, 0.5f * root, (u.y - v.x) * half);
        value = math.normalize(value);
    }

    /// <summary>From an orthonormal matrix; the translation is left out.</summary>
    public quaternion(float4x4 m) : this(new float3x3(m))
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator quaternion(float4 v) => new(v);

    public static quaternion AxisAngle(float3 axis, float angle)
    {
        math.sincos(0.5f * angle, out float sine, out float cosine);
        return new quaternion(new float4(axis * sine, cosine));
    }

    public static quaternion RotateX(float angle)
    {
        math.sincos(0.5f * angle, out float sine, out float cosine);
        return new quaternion(sine, 0f, 0f, cosine);
    }

    public static quaternion RotateY(float angle)
    {
        math.sincos(0.5f * angle, out float sine, out float cosine);
        return new quaternion(0f, sine, 0f, cosine);
    }

    public static quaternion RotateZ(float angle)
    {
        math.sincos(0.5f * angle, out float sine, out float cosine);
        return new quaternion(0f, 0f, sine, cosine);
    }

    /// <summary>First about x, then y, then z.</summary>
    public static quaternion EulerXYZ(float3 xyz) => math.mul(RotateZ(xyz.z), math.mul(RotateY(xyz.y), RotateX(xyz.x)));

    /// <summary>First about z, then x, then y: the order of Unity's inspector.</summary>
    public static quaternion EulerZXY(float3 xyz) => math.mul(RotateY(xyz.y), math.mul(RotateX(xyz.x), RotateZ(xyz.z)));

    public static quaternion EulerXYZ(float x, float y, float z) => EulerXYZ(new float3(x, y, z));

    public static quaternion EulerZXY(float x, float y, float z) => EulerZXY(new float3(x, y, z));

    public static quaternion LookRotation(float3 forward, float3 up) => new(float3x3.LookRotation(forward, up));

    public static quaternion LookRotationSafe(float3 forward, float3 up) => new(float3x3.LookRotationSafe(forward, up));

    public bool Equals(quaternion x) => value.Equals(x.value);

    public override bool Equals(object x) => x is quaternion q && Equals(q);

    public override int GetHashCode() => value.GetHashCode();

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) => "quaternion" + value.ToString(format, formatProvider)[6..];
}
