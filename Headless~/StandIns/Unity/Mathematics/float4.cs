using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

/// <summary>Four single-precision numbers; the named fields and the vector register hold the same 16 bytes.</summary>
[StructLayout(LayoutKind.Explicit, Size = 16, Pack = 4)]
public partial struct float4 : IEquatable<float4>, IFormattable
{
    [FieldOffset(0)] public float x;
    [FieldOffset(4)] public float y;
    [FieldOffset(8)] public float z;
    [FieldOffset(12)] public float w;
    [FieldOffset(0)] internal Vector128<float> lanes;

    public static readonly float4 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float x, float y, float z, float w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, z, w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float x, float y, float2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, y, zw.x, zw.y);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float x, float2 yz, float w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yz.x, yz.y, w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float x, float3 yzw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(x, yzw.x, yzw.y, yzw.z);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float2 xy, float z, float w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, z, w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float2 xy, float2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xy.x, xy.y, zw.x, zw.y);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float3 xyz, float w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(xyz.x, xyz.y, xyz.z, w);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(float v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(v);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal float4(Vector128<float> lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4(int v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float4(double v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4(int4 v) => new(Vector128.ConvertToSingle(v.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float4(uint4 v) => new(v.x, v.y, v.z, v.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float4(int4 v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.ConvertToSingle(v.V);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float4(bool4 v) => math.select(new float4(0f), new float4(1f), v);

    public float this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<float4, float>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<float4, float>(ref this), Index.Checked(index, 4)) = value;
    }

    public bool Equals(float4 rhs) => lanes == rhs.lanes;

    public override bool Equals(object o) => o is float4 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"float4({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, "
        + $"{z.ToString(format, formatProvider)}f, {w.ToString(format, formatProvider)}f)";
}
