using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Three signed integers.</summary>
public partial struct int3 : IEquatable<int3>, IFormattable
{
    public int x;
    public int y;
    public int z;

    public static readonly int3 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int3(int x, int y, int z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int3(int x, int2 yz)
    {
        this.x = x;
        this.y = yz.x;
        this.z = yz.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int3(int2 xy, int z)
    {
        this.x = xy.x;
        this.y = xy.y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int3(int v)
    {
        x = v;
        y = v;
        z = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator int3(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int3(float v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int3(float3 v) => new((int)v.x, (int)v.y, (int)v.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int3(uint v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int3(uint3 v) => new((int)v.x, (int)v.y, (int)v.z);

    public int this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<int3, int>(ref Unsafe.AsRef(in this)), Index.Checked(index, 3));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<int3, int>(ref this), Index.Checked(index, 3)) = value;
    }

    public bool Equals(int3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

    public override bool Equals(object o) => o is int3 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"int3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
}
