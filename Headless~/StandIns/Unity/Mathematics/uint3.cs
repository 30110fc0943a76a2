using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Three unsigned integers.</summary>
public partial struct uint3 : IEquatable<uint3>, IFormattable
{
    public uint x;
    public uint y;
    public uint z;

    public static readonly uint3 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint3(uint x, uint y, uint z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint3(uint x, uint2 yz)
    {
        this.x = x;
        this.y = yz.x;
        this.z = yz.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint3(uint2 xy, uint z)
    {
        this.x = xy.x;
        this.y = xy.y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint3(uint v)
    {
        x = v;
        y = v;
        z = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator uint3(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint3(float v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint3(float3 v) => new((uint)v.x, (uint)v.y, (uint)v.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint3(int v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint3(int3 v) => new((uint)v.x, (uint)v.y, (uint)v.z);

    public uint this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<uint3, uint>(ref Unsafe.AsRef(in this)), Index.Checked(index, 3));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<uint3, uint>(ref this), Index.Checked(index, 3)) = value;
    }

    public bool Equals(uint3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

    public override bool Equals(object o) => o is uint3 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"uint3({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, {z.ToString(format, formatProvider)})";
}
