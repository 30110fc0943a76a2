using System;

namespace UnityEngine;

public struct Vector4 : IEquatable<Vector4>, IFormattable
{
    public const float kEpsilon = 0.00001f;

    public float x;
    public float y;
    public float z;
    public float w;

    public Vector4(float x, float y, float z, float w)
    {
        this.x = x;
        this.y = y;
        this.z = z;
        this.w = w;
    }

    public static Vector4 zero => default;
    public static Vector4 one => new(1f, 1f, 1f, 1f);

    public float sqrMagnitude => Dot(this, this);
    public float magnitude => MathF.Sqrt(sqrMagnitude);

    public float this[int index]
    {
        get => index switch { 0 => x, 1 => y, 2 => z, 3 => w, _ => throw new IndexOutOfRangeException("Invalid Vector4 index!") };
        set
        {
            switch (index)
            {
                case 0: x = value; break;
                case 1: y = value; break;
                case 2: z = value; break;
                case 3: w = value; break;
                default: throw new IndexOutOfRangeException("Invalid Vector4 index!");
            }
        }
    }

    public static Vector4 operator +(Vector4 a, Vector4 b) => new(a.x + b.x, a.y + b.y, a.z + b.z, a.w + b.w);
    public static Vector4 operator -(Vector4 a, Vector4 b) => new(a.x - b.x, a.y - b.y, a.z - b.z, a.w - b.w);
    public static Vector4 operator -(Vector4 a) => new(-a.x, -a.y, -a.z, -a.w);
    public static Vector4 operator *(Vector4 a, float d) => new(a.x * d, a.y * d, a.z * d, a.w * d);
    public static Vector4 operator *(float d, Vector4 a) => a * d;
    public static Vector4 operator /(Vector4 a, float d) => new(a.x / d, a.y / d, a.z / d, a.w / d);
    public static bool operator ==(Vector4 lhs, Vector4 rhs) => (lhs - rhs).sqrMagnitude < kEpsilon * kEpsilon;
    public static bool operator !=(Vector4 lhs, Vector4 rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Vector3 v) => new(v.x, v.y, v.z, 0f);
    public static implicit operator Vector3(Vector4 v) => new(v.x, v.y, v.z);
    public static implicit operator Vector4(Vector2 v) => new(v.x, v.y, 0f, 0f);
    public static implicit operator Vector2(Vector4 v) => new(v.x, v.y);

    public static float Dot(Vector4 a, Vector4 b) => a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w;
    public static Vector4 Lerp(Vector4 a, Vector4 b, float t) => a + (b - a) * Mathf.Clamp01(t);

    public bool Equals(Vector4 other) => x == other.x && y == other.y && z == other.z && w == other.w;
    public override bool Equals(object other) => other is Vector4 v && Equals(v);
    public override int GetHashCode() => HashCode.Combine(x, y, z, w);
    public override string ToString() => ToString(null, null);
    public string ToString(string format) => ToString(format, null);
    public string ToString(string format, IFormatProvider formatProvider) => Numbers.Tuple(format, "F2", formatProvider, x, y, z, w);
}
