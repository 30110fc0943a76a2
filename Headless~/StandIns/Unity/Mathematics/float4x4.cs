using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Four columns of four numbers.</summary>
public partial struct float4x4 : IEquatable<float4x4>, IFormattable
{
    public float4 c0;
    public float4 c1;
    public float4 c2;
    public float4 c3;

    public static readonly float4x4 identity = new(
        new float4(1f, 0f, 0f, 0f), new float4(0f, 1f, 0f, 0f), new float4(0f, 0f, 1f, 0f), new float4(0f, 0f, 0f, 1f));
    public static readonly float4x4 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4x4(float4 c0, float4 c1, float4 c2, float4 c3)
    {
        this.c0 = c0;
        this.c1 = c1;
        this.c2 = c2;
        this.c3 = c3;
    }

    /// <summary>Row by row.</summary>
    public float4x4(
        float m00, float m01, float m02, float m03,
        float m10, float m11, float m12, float m13,
        float m20, float m21, float m22, float m23,
        float m30, float m31, float m32, float m33)
    {
        c0 = new float4(m00, m10, m20, m30);
        c1 = new float4(m01, m11, m21, m31);
        c2 = new float4(m02, m12, m22, m32);
        c3 = new float4(m03, m13, m23, m33);
    }

    public float4x4(float v)
    {
        c0 = v;
        c1 = v;
        c2 = v;
        c3 = v;
    }

    public float4x4(float3x3 rotation, float3 translation)
    {
        c0 = new float4(rotation.c0, 0f);
        c1 = new float4(rotation.c1, 0f);
        c2 = new float4(rotation.c2, 0f);
        c3 = new float4(translation, 1f);
    }

    public float4x4(quaternion rotation, float3 translation) : this(new float3x3(rotation), translation)
    {
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4x4(float v) => new(v);

    public ref float4 this[int index] =>
        ref Unsafe.Add(ref Unsafe.As<float4x4, float4>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4));

    public static float4x4 AxisAngle(float3 axis, float angle) => new(quaternion.AxisAngle(axis, angle), default);

    public static float4x4 RotateX(float angle) => new(quaternion.RotateX(angle), default);

    public static float4x4 RotateY(float angle) => new(quaternion.RotateY(angle), default);

    public static float4x4 RotateZ(float angle) => new(quaternion.RotateZ(angle), default);

    public static float4x4 Scale(float s) => Scale(new float3(s));

    public static float4x4 Scale(float x, float y, float z) => Scale(new float3(x, y, z));

    public static float4x4 Scale(float3 scales) => new(float3x3.Scale(scales), default);

    public static float4x4 Translate(float3 vector) => new(float3x3.identity, vector);

    public static float4x4 TRS(float3 translation, quaternion rotation, float3 scale)
    {
        float3x3 r = new(rotation);
        return new float4x4(new float3x3(r.c0 * scale.x, r.c1 * scale.y, r.c2 * scale.z), translation);
    }

    public bool Equals(float4x4 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2) && c3.Equals(rhs.c3);

    public override bool Equals(object o) => o is float4x4 m && Equals(m);

    public override int GetHashCode() => HashCode.Combine(c0, c1, c2, c3);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        float4x4 rows = math.transpose(this);
        string Row(float4 r) => r.ToString(format, formatProvider)[7..^1];
        return $"float4x4({Row(rows.c0)},  {Row(rows.c1)},  {Row(rows.c2)},  {Row(rows.c3)})";
    }
}
