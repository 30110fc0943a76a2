using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Three columns of three numbers.</summary>
public partial struct float3x3 : IEquatable<float3x3>, IFormattable
{
    public float3 c0;
    public float3 c1;
    public float3 c2;

    public static readonly float3x3 identity = new(1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f);
    public static readonly float3x3 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3x3(float3 c0, float3 c1, float3 c2)
    {
        this.c0 = c0;
        this.c1 = c1;
        this.c2 = c2;
    }

    /// <summary>Row by row.</summary>
    public float3x3(float m00, float m01, float m02, float m10, float m11, float m12, float m20, float m21, float m22)
    {
        c0 = new float3(m00, m10, m20);
        c1 = new float3(m01, m11, m21);
        c2 = new float3(m02, m12, m22);
    }

    public float3x3(float v)
    {
        c0 = v;
        c1 = v;
        c2 = v;
    }

    public float3x3(float4x4 f4x4)
    {
        c0 = f4x4.c0.xyz;
        c1 = f4x4.c1.xyz;
        c2 = f4x4.c2.xyz;
    }

    /// <summary>The rotation of a unit quaternion.</summary>
    public float3x3(quaternion q)
    {
        float x = q.value.x, y = q.value.y, z = q.value.z, w = q.value.w;
        c0 = new float3(1f - 2f * (y * y + z * z), 2f * (x * y + w * z), 2f * (x * z - w * y));
        c1 = new float3(2f * (x * y - w * z), 1f - 2f * (x * x + z * z), 2f * (y * z + w * x));
        c2 = new float3(2f * (x * z + w * y), 2f * (y * z - w * x), 1f - 2f * (x * x + y * y));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3x3(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float3x3(float4x4 f4x4) => new(f4x4);

    public ref float3 this[int index] =>
        ref Unsafe.Add(ref Unsafe.As<float3x3, float3>(ref Unsafe.AsRef(in this)), Index.Checked(index, 3));

    public static float3x3 AxisAngle(float3 axis, float angle) => new(quaternion.AxisAngle(axis, angle));

    public static float3x3 RotateX(float angle) => new(quaternion.RotateX(angle));

    public static float3x3 RotateY(float angle) => new(quaternion.RotateY(angle));

    public static float3x3 RotateZ(float angle) => new(quaternion.RotateZ(angle));

    public static float3x3 Scale(float s) => Scale(s, s, s);

    public static float3x3 Scale(float3 v) => Scale(v.x, v.y, v.z);

    public static float3x3 Scale(float x, float y, float z) => new(x, 0f, 0f, 0f, y, 0f, 0f, 0f, z);

    /// <summary>Columns right, up, forward; both arguments unit vectors that are not parallel.</summary>
    public static float3x3 LookRotation(float3 forward, float3 up)
    {
        float3 right = math.normalize(math.cross(up, forward));
        return new float3x3(right, math.cross(forward, right), forward);
    }

    /// <summary>Rotation as by LookRotation, for any arguments; the identity where they give no rotation.</summary>
    public static float3x3 LookRotationSafe(float3 forward, float3 up)
    {
        float forwardLength = math.dot(forward, forward);
        float upLength = math.dot(up, up);
        forward *= math.rsqrt(forwardLength);
        up *= math.rsqrt(upLength);
        float3 right = math.cross(up, forward);
        float rightLength = math.dot(right, right);
        right *= math.rsqrt(rightLength);
        float smallest = math.min(math.min(forwardLength, upLength), rightLength);
        float largest = math.max(math.max(forwardLength, upLength), rightLength);
        bool usable = smallest > 1e-35f && largest < 1e35f
            && math.isfinite(forwardLength) && math.isfinite(upLength) && math.isfinite(rightLength);
        return usable ? new float3x3(right, math.cross(forward, right), forward) : identity;
    }

    public bool Equals(float3x3 rhs) => c0.Equals(rhs.c0) && c1.Equals(rhs.c1) && c2.Equals(rhs.c2);

    public override bool Equals(object o) => o is float3x3 m && Equals(m);

    public override int GetHashCode() => HashCode.Combine(c0, c1, c2);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider)
    {
        float3x3 rows = math.transpose(this);
        string Row(float3 r) => r.ToString(format, formatProvider)[7..^1];
        return $"float3x3({Row(rows.c0)},  {Row(rows.c1)},  {Row(rows.c2)})";
    }
}
