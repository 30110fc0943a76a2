using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Two single-precision numbers.</summary>
public partial struct float2 : IEquatable<float2>, IFormattable
{
    public float x;
    public float y;

    public static readonly float2 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float2(float x, float y)
    {
        this.x = x;
        this.y = y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float2(float v)
    {
        x = v;
        y = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float2(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float2(int v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float2(double v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float2(int2 v) => new(v.x, v.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float2(uint2 v) => new(v.x, v.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float2(int2 v)
    {
        x = v.x;
        y = v.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float2(bool2 v) => math.select(new float2(0f), new float2(1f), v);

    public float this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<float2, float>(ref Unsafe.AsRef(in this)), Index.Checked(index, 2));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<float2, float>(ref this), Index.Checked(index, 2)) = value;
    }

    public bool Equals(float2 rhs) => x == rhs.x && y == rhs.y;

    public override bool Equals(object o) => o is float2 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"float2({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f)";
}
