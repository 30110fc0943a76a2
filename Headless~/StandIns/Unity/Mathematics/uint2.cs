using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Two unsigned integers.</summary>
public partial struct uint2 : IEquatable<uint2>, IFormattable
{
    public uint x;
    public uint y;

    public static readonly uint2 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint2(uint x, uint y)
    {
        this.x = x;
        this.y = y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint2(uint v)
    {
        x = v;
        y = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator uint2(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint2(float v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint2(float2 v) => new((uint)v.x, (uint)v.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint2(int v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint2(int2 v) => new((uint)v.x, (uint)v.y);

    public uint this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<uint2, uint>(ref Unsafe.AsRef(in this)), Index.Checked(index, 2));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<uint2, uint>(ref this), Index.Checked(index, 2)) = value;
    }

    public bool Equals(uint2 rhs) => x == rhs.x && y == rhs.y;

    public override bool Equals(object o) => o is uint2 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"uint2({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)})";
}
