using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

/// <summary>Three single-precision numbers.</summary>
public partial struct float3 : IEquatable<float3>, IFormattable
{
    public float x;
    public float y;
    public float z;

    public static readonly float3 zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3(float x, float y, float z)
    {
        this.x = x;
        this.y = y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3(float x, float2 yz)
    {
        this.x = x;
        this.y = yz.x;
        this.z = yz.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3(float2 xy, float z)
    {
        this.x = xy.x;
        this.y = xy.y;
        this.z = z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3(float v)
    {
        x = v;
        y = v;
        z = v;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3(float v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3(int v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float3(double v) => new((float)v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3(int3 v) => new(v.x, v.y, v.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator float3(uint3 v) => new(v.x, v.y, v.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float3(int3 v)
    {
        x = v.x;
        y = v.y;
        z = v.z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static explicit operator float3(bool3 v) => math.select(new float3(0f), new float3(1f), v);

    public float this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<float3, float>(ref Unsafe.AsRef(in this)), Index.Checked(index, 3));
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<float3, float>(ref this), Index.Checked(index, 3)) = value;
    }

    public bool Equals(float3 rhs) => x == rhs.x && y == rhs.y && z == rhs.z;

    public override bool Equals(object o) => o is float3 rhs && Equals(rhs);

    public override int GetHashCode() => (int)math.hash(this);

    public override string ToString() => ToString(null, null);

    public string ToString(string format, IFormatProvider formatProvider) =>
        $"float3({x.ToString(format, formatProvider)}f, {y.ToString(format, formatProvider)}f, {z.ToString(format, formatProvider)}f)";
}
