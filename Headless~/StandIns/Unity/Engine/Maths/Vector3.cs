using System;

namespace UnityEngine;

public struct Vector3 : IEquatable<Vector3>, IFormattable
{
    public const float kEpsilon = 0.00001f;

    public float x;
    public float y;
    public float z;

    public Vector3(float x, float y, float z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    public static Vector3 zero => default;
    public static Vector3 one => new(1f, 1f, 1f);
    public static Vector3 right => new(1f, 0f, 0f);
    public static Vector3 up => new(0f, 1f, 0f);
    public static Vector3 forward => new(0f, 0f, 1f);
    public static Vector3 left => new(-1f, 0f, 0f);
    public static Vector3 down => new(0f, -1f, 0f);
    public static Vector3 back => new(0f, 0f, -1f);
    public static Vector3 positiveInfinity => new(float.PositiveInfinity, float.PositiveInfinity, float.PositiveInfinity);
    public static Vector3 negativeInfinity => new(float.NegativeInfinity, float.NegativeInfinity, float.NegativeInfinity);

    public float sqrMagnitude => x * x + y * y + z * z;
    public float magnitude => MathF.Sqrt(sqrMagnitude);
    public Vector3 normalized => Normalize(this);

    public float this[int index]
    {
        get => index switch { 0 => x, 1 => y, 2 => z, _ => throw new IndexOutOfRangeException("Invalid Vector3 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector3 index!");
            }
        }
    }

    public static Vector3 operator +(Vector3 a, Vector3 b) => new(a.x + b.x, a.y + b.y, a.z + b.z);
    public static Vector3 operator -(Vector3 a, Vector3 b) => new(a.x - b.x, a.y - b.y, a.z - b.z);
    public static Vector3 operator -(Vector3 a) => new(-a.x, -a.y, -a.z);
    public static Vector3 operator *(Vector3 a, float d) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator *(float d, Vector3 a) => new(a.x * d, a.y * d, a.z * d);
    public static Vector3 operator /(Vector3 a, float d) => new(a.x / d, a.y / d, a.z / d);
    public static bool operator ==(Vector3 lhs, Vector3 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector3 lhs, Vector3 rhs) => !(lhs == rhs);

    public static float Dot(Vector3 lhs, Vector3 rhs) => lhs.x * rhs.x + lhs.y * rhs.y + lhs.z * rhs.z;
    public static Vector3 Cross(Vector3 lhs, Vector3 rhs) =>
        new(lhs.y * rhs.z - lhs.z * rhs.y, lhs.z * rhs.x - lhs.x * rhs.z, lhs.x * rhs.y - lhs.y * rhs.x);
    public static float Distance(Vector3 a, Vector3 b) => (a - b).magnitude;
    public static Vector3 Min(Vector3 lhs, Vector3 rhs) => new(MathF.Min(lhs.x, rhs.x), MathF.Min(lhs.y, rhs.y), MathF.Min(lhs.z, rhs.z));
    public static Vector3 Max(Vector3 lhs, Vector3 rhs) => new(MathF.Max(lhs.x, rhs.x), MathF.Max(lhs.y, rhs.y), MathF.Max(lhs.z, rhs.z));
    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => a + (b - a) * Mathf.Clamp01(t);
    public static Vector3 LerpUnclamped(Vector3 a, Vector3 b, float t) => a + (b - a) * t;
    public static Vector3 Scale(Vector3 a, Vector3 b) => new(a.x * b.x, a.y * b.y, a.z * b.z);
    public static Vector3 Reflect(Vector3 inDirection, Vector3 inNormal) => inDirection - 2f * Dot(inNormal, inDirection) * inNormal;
    public static Vector3 ProjectOnPlane(Vector3 vector, Vector3 planeNormal) => vector - Project(vector, planeNormal);

    public static Vector3 ClampMagnitude(Vector3 vector, float maxLength) =>
        vector.sqrMagnitude > maxLength * maxLength ? vector * (maxLength / vector.magnitude) : vector;

    public static Vector3 MoveTowards(Vector3 current, Vector3 target, float maxDistanceDelta)
    {
        Vector3 way = target - current;
        float length = way.magnitude;
        bool arrives = length == 0f || (maxDistanceDelta >= 0f && length <= maxDistanceDelta);
        return arrives ? target : current + way * (maxDistanceDelta / length);
    }

    public static float SignedAngle(Vector3 from, Vector3 to, Vector3 axis) =>
        Angle(from, to) * Mathf.Sign(Dot(axis, Cross(from, to)));

    public static Vector3 Project(Vector3 vector, Vector3 onNormal)
    {
        float square = Dot(onNormal, onNormal);
        return square < float.Epsilon ? zero : onNormal * (Dot(vector, onNormal) / square);
    }

    public static Vector3 Normalize(Vector3 value)
    {
        float length = value.magnitude;
        return length > kEpsilon ? value / length : zero;
    }

    public static float Angle(Vector3 from, Vector3 to)
    {
        float length = MathF.Sqrt(from.sqrMagnitude * to.sqrMagnitude);
        return length < 1e-15f ? 0f : MathF.Acos(Mathf.Clamp(Dot(from, to) / length, -1f, 1f)) * Mathf.Rad2Deg;
    }

    public void Normalize() => this = Normalize(this);
    public void Scale(Vector3 scale) => this = Scale(this, scale);
    public void Set(float newX, float newY, float newZ) => this = new Vector3(newX, newY, newZ);

    public bool Equals(Vector3 other) => x == other.x && y == other.y && z == other.z;
    public override bool Equals(object other) => other is Vector3 v && Equals(v);
    public override int GetHashCode() => HashCode.Combine(x, y, z);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) => Numbers.Tuple(format, "F2", formatProvider, x, y, z);
}
