using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

/// <summary>Four signed integers; the named fields and the vector register hold the same 16 bytes.</summary>
[StructLayout(LayoutKind.Explicit, Size = 16, Pack = 4)]
public partial struct int4 : IEquatable<int4>, IFormattable
{
    [FieldOffset(0)] public int x;
    [FieldOffset(4)] public int y;
    [FieldOffset(8)] public int z;
    [FieldOffset(12)] public int w;
    [FieldOffset(0)] internal Vector128<float> lanes;

    public static readonly int4 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int x, int y, int z, int w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int x, int y, int2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, zw.x, zw.y).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int x, int2 yz, int w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yz.x, yz.y, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int x, int3 yzw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yzw.x, yzw.y, yzw.z).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int2 xy, int z, int w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int2 xy, int2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, zw.x, zw.y).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int3 xyz, int w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xyz.x, xyz.y, xyz.z, w).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public int4(int v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(v).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal int4(Vector128<float> lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal int4(Vector128<int> v)
    {
        Unsafe.SkipInit(out this);
        lanes = v.AsSingle();
    }

    internal Vector128<int> V
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => lanes.AsInt32();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator int4(int v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int4(float v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int4(float4 v) => new(int4.Truncate(v.lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int4(uint v) => new((int)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator int4(uint4 v) => new(v.lanes);

    // C# truncates out-of-range values to an unspecified number; Burst on x86 gives int.MinValue, as this does.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<int> Truncate(Vector128<float> v) => Vector128.ConvertToInt32Native(v);

    public int this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<int4, int>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<int4, int>(ref this), Index.Checked(index, 4)) = value;
    }

    public bool Equals(int4 rhs) => V == rhs.V;

    public override bool Equals(object o) => o is int4 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"int4({x.ToString(format, formatProvider)}, {y.ToString(format, formatProvider)}, "
        + $"{z.ToString(format, formatProvider)}, {w.ToString(format, formatProvider)})";
}
