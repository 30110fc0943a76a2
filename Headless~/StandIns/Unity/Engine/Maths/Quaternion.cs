using System;
using Unity.Mathematics;

namespace UnityEngine;

public struct Quaternion : IEquatable<Quaternion>, IFormattable
{
    public const float kEpsilon = 0.000001f;

    public float x;
    public float y;
    public float z;
    public float w;

    public Quaternion(float x, float y, float z, float w)
    {
        this.x = x;
        this.y = y;
        this.z = z;
        this.w = w;
    }

    public static Quaternion identity => new(0f, 0f, 0f, 1f);

    public Quaternion normalized => Normalize(this);

    /// <summary>Degrees, 0 to 360: about z first, then x, then y.</summary>
    public Vector3 eulerAngles
    {
        get => EulerAngles.From(this);
        set => this = Euler(value);
    }

    public float this[int index]
    {
        get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Quaternion index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                case 3: w = value; break;
                default: throw new IndexOutOfRangeException("Invalid Quaternion index!");
            }
        }
    }

    public static Quaternion operator *(Quaternion lhs, Quaternion rhs) => new(
        lhs.w * rhs.x + lhs.x * rhs.w + lhs.y * rhs.z - lhs.z * rhs.y,
        lhs.w * rhs.y + lhs.y * rhs.w + lhs.z * rhs.x - lhs.x * rhs.z,
        lhs.w * rhs.z + lhs.z * rhs.w + lhs.x * rhs.y - lhs.y * rhs.x,
        lhs.w * rhs.w - lhs.x * rhs.x - lhs.y * rhs.y - lhs.z * rhs.z);

    public static Vector3 operator *(Quaternion rotation, Vector3 point)
    {
        Vector3 u = new(rotation.x, rotation.y, rotation.z);
        Vector3 t = 2f * Vector3.Cross(u, point);
        return point + rotation.w * t + Vector3.Cross(u, t);
    }

    public static bool operator ==(Quaternion lhs, Quaternion rhs) => Dot(lhs, rhs) > 1f - kEpsilon;
    public static bool operator !=(Quaternion lhs, Quaternion rhs) => !(lhs == rhs);

    public static float Dot(Quaternion a, Quaternion b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;

    /// <summary>Degrees between two rotations.</summary>
    public static float Angle(Quaternion a, Quaternion b)
    {
        float dot = MathF.Min(MathF.Abs(Dot(a, b)), 1f);
        return dot > 1f - kEpsilon ? 0f : MathF.Acos(dot) * 2f * Mathf.Rad2Deg;
    }

    public static Quaternion AngleAxis(float angle, Vector3 axis)
    {
        if (axis.sqrMagnitude == 0f)
            return identity;
        return quaternion.AxisAngle(axis / axis.magnitude, angle * Mathf.Deg2Rad);
    }

    public static Quaternion Euler(Vector3 euler) => quaternion.EulerZXY((float3)euler * Mathf.Deg2Rad);
    public static Quaternion Euler(float x, float y, float z) => Euler(new Vector3(x, y, z));

    public static Quaternion FromToRotation(Vector3 fromDirection, Vector3 toDirection)
    {
        Vector3 from = fromDirection.normalized, to = toDirection.normalized;
        float cosine = Vector3.Dot(from, to);
        if (cosine < -0.999999f)
        {
            var axis = Vector3.Cross(Vector3.right, from);
            return AngleAxis(180f, axis.sqrMagnitude > 1e-6f ? axis : Vector3.Cross(Vector3.up, from));
        }

        var cross = Vector3.Cross(from, to);
        return Normalize(new Quaternion(cross.x, cross.y, cross.z, 1f + cosine));
    }

    public static Quaternion Inverse(Quaternion rotation)
    {
        float square = Dot(rotation, rotation);
        return square == 0f
            ? rotation
            : new Quaternion(-rotation.x / square, -rotation.y / square, -rotation.z / square, rotation.w / square);
    }

    public static Quaternion Lerp(Quaternion a, Quaternion b, float t) => LerpUnclamped(a, b, Mathf.Clamp01(t));

    public static Quaternion LerpUnclamped(Quaternion a, Quaternion b, float t)
    {
        float s = Dot(a, b) < 0f ? -t : t;
        return Normalize(new Quaternion(
            a.x * (1f - t) + b.x * s, a.y * (1f - t) + b.y * s, a.z * (1f - t) + b.z * s, a.w * (1f - t) + b.w * s));
    }

    public static Quaternion Slerp(Quaternion a, Quaternion b, float t) => SlerpUnclamped(a, b, Mathf.Clamp01(t));
    public static Quaternion SlerpUnclamped(Quaternion a, Quaternion b, float t) => math.slerp(a, b, t);

    public static Quaternion RotateTowards(Quaternion from, Quaternion to, float maxDegreesDelta)
    {
        float angle = Angle(from, to);
        return angle == 0f ? to : SlerpUnclamped(from, to, MathF.Min(1f, maxDegreesDelta / angle));
    }

    public static Quaternion LookRotation(Vector3 forward) => LookRotation(forward, Vector3.up);

    public static Quaternion LookRotation(Vector3 forward, Vector3 upwards)
    {
        Vector3 f = forward.normalized;
        if (f == Vector3.zero)
            return identity;
        var right = Vector3.Cross(upwards, f);
        return right.magnitude < 1e-6f * upwards.magnitude || upwards == Vector3.zero
            ? FromToRotation(Vector3.forward, f)
            : quaternion.LookRotation(f, upwards);
    }

    public static Quaternion Normalize(Quaternion q)
    {
        float length = MathF.Sqrt(Dot(q, q));
        return length < Mathf.Epsilon ? identity : new Quaternion(q.x / length, q.y / length, q.z / length, q.w / length);
    }

    public void Normalize() => this = Normalize(this);

    public void Set(float newX, float newY, float newZ, float newW) => this = new Quaternion(newX, newY, newZ, newW);
    public void SetLookRotation(Vector3 view, Vector3 up) => this = LookRotation(view, up);
    public void SetFromToRotation(Vector3 fromDirection, Vector3 toDirection) => this = FromToRotation(fromDirection, toDirection);

    /// <summary>The angle in degrees, 0 to 360, and the unit axis.</summary>
    public void ToAngleAxis(out float angle, out Vector3 axis)
    {
        Quaternion q = Normalize(this);
        Vector3 part = new(q.x, q.y, q.z);
        float sine = part.magnitude;
        angle = 2f * MathF.Atan2(sine, q.w) * Mathf.Rad2Deg;
        axis = sine < kEpsilon ? Vector3.right : part / sine;
    }

    public bool Equals(Quaternion other) => x.Equals(other.x) && y.Equals(other.y) && z.Equals(other.z) && w.Equals(other.w);
    public override bool Equals(object other) => other is Quaternion q && Equals(q);
    public override int GetHashCode() => HashCode.Combine(x, y, z, w);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) => Numbers.Tuple(format, "F5", formatProvider, x, y, z, w);
}
