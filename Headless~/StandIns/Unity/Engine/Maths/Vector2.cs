using System;

namespace UnityEngine;

public struct Vector2 : IEquatable<Vector2>, IFormattable
{
    public const float kEpsilon = 0.00001f;

    public float x;
    public float y;

    public Vector2(float x, float y)
    {
        this.x = x;
        this.y = y;
    }

    public static Vector2 zero => default;
    public static Vector2 one => new(1f, 1f);
    public static Vector2 up => new(0f, 1f);
    public static Vector2 right => new(1f, 0f);

    public float sqrMagnitude => x * x + y * y;
    public float magnitude => MathF.Sqrt(sqrMagnitude);
    public Vector2 normalized => magnitude > kEpsilon ? this / magnitude : zero;

    public static Vector2 operator +(Vector2 a, Vector2 b) => new(a.x + b.x, a.y + b.y);
    public static Vector2 operator -(Vector2 a, Vector2 b) => new(a.x - b.x, a.y - b.y);
    public static Vector2 operator -(Vector2 a) => new(-a.x, -a.y);
    public static Vector2 operator *(Vector2 a, float d) => new(a.x * d, a.y * d);
    public static Vector2 operator *(float d, Vector2 a) => a * d;
    public static Vector2 operator /(Vector2 a, float d) => new(a.x / d, a.y / d);
    public static bool operator ==(Vector2 lhs, Vector2 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector2 lhs, Vector2 rhs) => !(lhs == rhs);
    public static implicit operator Vector2(Vector3 v) => new(v.x, v.y);
    public static implicit operator Vector3(Vector2 v) => new(v.x, v.y, 0f);

    public static float Dot(Vector2 lhs, Vector2 rhs) => lhs.x * rhs.x + lhs.y * rhs.y;
    public static float Distance(Vector2 a, Vector2 b) => (a - b).magnitude;
    public static Vector2 ClampMagnitude(Vector2 vector, float maxLength) =>
        vector.sqrMagnitude > maxLength * maxLength ? vector * (maxLength / vector.magnitude) : vector;
    public static Vector2 Lerp(Vector2 a, Vector2 b, float t) => a + (b - a) * Mathf.Clamp01(t);

    public bool Equals(Vector2 other) => x == other.x && y == other.y;
    public override bool Equals(object other) => other is Vector2 v && Equals(v);
    public override int GetHashCode() => HashCode.Combine(x, y);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) => Numbers.Tuple(format, "F2", formatProvider, x, y);
}
