using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Three truth values.</summary>
public partial struct bool3 : IEquatable<bool3>
{
    public bool x;
    public bool y;
    public bool z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool3(bool x, bool y, bool z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool3(bool x, bool2 yz)
    {
        this.x = x;
        this.y = yz.x;
        this.z = yz.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool3(bool2 xy, bool z)
    {
        this.x = xy.x;
        this.y = xy.y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool3(bool v)
    {
        x = v;
        y = v;
        z = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator bool3(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator &(bool3 lhs, bool3 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y, lhs.z & rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator |(bool3 lhs, bool3 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y, lhs.z | rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator ^(bool3 lhs, bool3 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y, lhs.z ^ rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator ==(bool3 lhs, bool3 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y, lhs.z == rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator !=(bool3 lhs, bool3 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y, lhs.z != rhs.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 operator !(bool3 val) => new(!val.x, !val.y, !val.z);

    public bool this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<bool3, bool>(ref Unsafe.AsRef(in this)), Index.Checked(index, 3));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<bool3, bool>(ref this), Index.Checked(index, 3)) = value;
    }

    public bool Equals(bool3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

    public override bool Equals(object o) => o is bool3 rhs && Equals(rhs);

    public override int GetHashCode() => (x ? 1 : 0) | (y ? 2 : 0) | (z ? 4 : 0);

    public override string ToString() => $"bool3({x}, {y}, {z})";
}
