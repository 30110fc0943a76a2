using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Two signed integers.</summary>
public partial struct int2 : IEquatable<int2>, IFormattable
{
    public int x;
    public int y;

    public static readonly int2 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int2(int x, int y)
    {
        this.x = x;
        this.y = y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int2(int v)
    {
        x = v;
        y = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator int2(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int2(float v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int2(float2 v) => new((int)v.x, (int)v.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int2(uint v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int2(uint2 v) => new((int)v.x, (int)v.y);

    public int this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<int2, int>(ref Unsafe.AsRef(in this)), Index.Checked(index, 2));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<int2, int>(ref this), Index.Checked(index, 2)) = value;
    }

    public bool Equals(int2 rhs) => x == rhs.x && y == rhs.y;

    public override bool Equals(object o) => o is int2 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"int2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
}
