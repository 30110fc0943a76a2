using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Two truth values.</summary>
public partial struct bool2 : IEquatable<bool2>
{
    public bool x;
    public bool y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool2(bool x, bool y)
    {
        this.x = x;
        this.y = y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool2(bool v)
    {
        x = v;
        y = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator bool2(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator &(bool2 lhs, bool2 rhs) => new(lhs.x & rhs.x, lhs.y & rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator |(bool2 lhs, bool2 rhs) => new(lhs.x | rhs.x, lhs.y | rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator ^(bool2 lhs, bool2 rhs) => new(lhs.x ^ rhs.x, lhs.y ^ rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator ==(bool2 lhs, bool2 rhs) => new(lhs.x == rhs.x, lhs.y == rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator !=(bool2 lhs, bool2 rhs) => new(lhs.x != rhs.x, lhs.y != rhs.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 operator !(bool2 val) => new(!val.x, !val.y);

    public bool this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<bool2, bool>(ref Unsafe.AsRef(in this)), Index.Checked(index, 2));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<bool2, bool>(ref this), Index.Checked(index, 2)) = value;
    }

    public bool Equals(bool2 rhs) => x == rhs.x && y == rhs.y;

    public override bool Equals(object o) => o is bool2 rhs && Equals(rhs);

    public override int GetHashCode() => (x ? 1 : 0) | (y ? 2 : 0);

    public override string ToString() => $"bool2({x}, {y})";
}
