using System;

namespace UnityEngine;

public struct Color : IEquatable<Color>
{
    public float r;
    public float g;
    public float b;
    public float a;

    public Color(float r, float g, float b, float a)
    {
        this.r = r;
        this.g = g;
        this.b = b;
        this.a = a;
    }

    public Color(float r, float g, float b) : this(r, g, b, 1f)
    {
    }

    public float this[int index]
    {
        get =>
            index switch { 0 => r, 1 => g, 2 => b, 3 => a, _ => throw new IndexOutOfRangeException("Invalid Color index(" + index + ")!") };
        set
        {
            switch (index)
            {
                case 0: r = value; break;
                case 1: g = value; break;
                case 2: b = value; break;
                case 3: a = value; break;
                default: throw new IndexOutOfRangeException("Invalid Color index(" + index + ")!");
            }
        }
    }

    public static Color white => new(1f, 1f, 1f);
    public static Color black => new(0f, 0f, 0f);
    public static Color clear => default;
    public static Color gray => new(0.5f, 0.5f, 0.5f);
    public static Color grey => gray;
    public static Color red => new(1f, 0f, 0f);
    public static Color green => new(0f, 1f, 0f);
    public static Color blue => new(0f, 0f, 1f);
    public static Color cyan => new(0f, 1f, 1f);
    public static Color magenta => new(1f, 0f, 1f);
    public static Color yellow => new(1f, 235f / 255f, 4f / 255f);

    public static Color operator *(Color a, float b) => new(a.r * b, a.g * b, a.b * b, a.a * b);
    public static Color operator *(Color a, Color b) => new(a.r * b.r, a.g * b.g, a.b * b.b, a.a * b.a);
    public static bool operator ==(Color lhs, Color rhs) => (Vector4)lhs == (Vector4)rhs;
    public static bool operator !=(Color lhs, Color rhs) => !(lhs == rhs);
    public static implicit operator Vector4(Color c) => new(c.r, c.g, c.b, c.a);
    public static implicit operator Color(Vector4 v) => new(v.x, v.y, v.z, v.w);

    public static Color Lerp(Color a, Color b, float t)
    {
        t = Mathf.Clamp01(t);
        return new Color(a.r + (b.r - a.r) * t, a.g + (b.g - a.g) * t, a.b + (b.b - a.b) * t, a.a + (b.a - a.a) * t);
    }

    /// <summary>Hue, saturation and value from 0 to 1.</summary>
    public static Color HSVToRGB(float H, float S, float V)
    {
        float Channel(float offset)
        {
            float k = Mathf.Repeat(offset + 6f * H, 6f);
            return V - V * S * Mathf.Clamp01(Mathf.Min(k, 4f - k));
        }

        return new Color(Channel(5f), Channel(3f), Channel(1f));
    }

    public bool Equals(Color other) => r.Equals(other.r) && g.Equals(other.g) && b.Equals(other.b) && a.Equals(other.a);
    public override bool Equals(object other) => other is Color c && Equals(c);
    public override int GetHashCode() => HashCode.Combine(r, g, b, a);
    public override string ToString() => "RGBA" + Numbers.Tuple(null, "F3", null, r, g, b, a);
}

public struct Color32
{
    public byte r;
    public byte g;
    public byte b;
    public byte a;

    public Color32(byte r, byte g, byte b, byte a)
    {
        this.r = r;
        this.g = g;
        this.b = b;
        this.a = a;
    }

    public static implicit operator Color32(Color c) => new(Byte(c.r), Byte(c.g), Byte(c.b), Byte(c.a));
    public static implicit operator Color(Color32 c) => new(c.r / 255f, c.g / 255f, c.b / 255f, c.a / 255f);

    private static byte Byte(float value) => (byte)MathF.Round(Mathf.Clamp01(value) * 255f);
}
