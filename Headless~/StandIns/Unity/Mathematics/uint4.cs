using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

/// <summary>Four unsigned integers; the named fields and the vector register hold the same 16 bytes.</summary>
[StructLayout(LayoutKind.Explicit, Size = 16, Pack = 4)]
public partial struct uint4 : IEquatable<uint4>, IFormattable
{
    [FieldOffset(0)] public uint x;
    [FieldOffset(4)] public uint y;
    [FieldOffset(8)] public uint z;
    [FieldOffset(12)] public uint w;
    [FieldOffset(0)] internal Vector128<float> lanes;

    public static readonly uint4 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint x, uint y, uint z, uint w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint x, uint y, uint2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, zw.x, zw.y).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint x, uint2 yz, uint w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yz.x, yz.y, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint x, uint3 yzw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yzw.x, yzw.y, yzw.z).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint2 xy, uint z, uint w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint2 xy, uint2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, zw.x, zw.y).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint3 xyz, uint w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xyz.x, xyz.y, xyz.z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public uint4(uint v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(v).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal uint4(Vector128<float> lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal uint4(Vector128<uint> v)
    {
        Unsafe.SkipInit(out this);
        lanes = v.AsSingle();
    }

    internal Vector128<uint> V
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => lanes.AsUInt32();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator uint4(uint v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint4(float v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint4(float4 v) => new((uint)v.x, (uint)v.y, (uint)v.z, (uint)v.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint4(int v) => new((uint)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator uint4(int4 v) => new(v.lanes);

    public uint this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<uint4, uint>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<uint4, uint>(ref this), Index.Checked(index, 4)) = value;
    }

    public bool Equals(uint4 rhs) => V == rhs.V;

    public override bool Equals(object o) => o is uint4 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"uint4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, "
        + $"{z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
}
