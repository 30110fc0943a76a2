using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

/// <summary>Four truth values, one in the lowest byte of each lane of a vector register; the other bytes are zero.</summary>
[StructLayout(LayoutKind.Explicit, Size = 16)]
public partial struct bool4 : IEquatable<bool4>
{
    [FieldOffset(0)] public bool x;
    [FieldOffset(4)] public bool y;
    [FieldOffset(8)] public bool z;
    [FieldOffset(12)] public bool w;
    [FieldOffset(0)] internal Vector4 lanes;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool y, bool z, bool w)
    {
        lanes = default;
        this.x = x;
        this.y = y;
        this.z = z;
        this.w = w;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool y, bool2 zw)
    {
        lanes = default;
        this.x = x;
        this.y = y;
        this.z = zw.x;
        this.w = zw.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool2 yz, bool w)
    {
        lanes = default;
        this.x = x;
        this.y = yz.x;
        this.z = yz.y;
        this.w = w;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool3 yzw)
    {
        lanes = default;
        this.x = x;
        this.y = yzw.x;
        this.z = yzw.y;
        this.w = yzw.z;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool2 xy, bool z, bool w)
    {
        lanes = default;
        this.x = xy.x;
        this.y = xy.y;
        this.z = z;
        this.w = w;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool2 xy, bool2 zw)
    {
        lanes = default;
        this.x = xy.x;
        this.y = xy.y;
        this.z = zw.x;
        this.w = zw.y;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool3 xyz, bool w)
    {
        lanes = default;
        this.x = xyz.x;
        this.y = xyz.y;
        this.z = xyz.z;
        this.w = w;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(v ? 1u : 0u).AsSingle().AsVector4();
    }

    // From a mask whose lanes are all zeros or all ones.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal bool4(Vector128<uint> mask)
    {
        Unsafe.SkipInit(out this);
        lanes = (mask >>> 31).AsSingle().AsVector4();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool4(Vector4 lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }

    internal Vector128<uint> Bits
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => lanes.AsVector128().AsUInt32();
    }

    // All ones where true.
    internal Vector128<int> Mask
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector128.GreaterThan(lanes.AsVector128().AsInt32(), Vector128<int>.Zero);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator bool4(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator &(bool4 lhs, bool4 rhs) => new((lhs.Bits & rhs.Bits).AsSingle().AsVector4());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator |(bool4 lhs, bool4 rhs) => new((lhs.Bits | rhs.Bits).AsSingle().AsVector4());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ^(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits).AsSingle().AsVector4());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits ^ Vector128<uint>.One).AsSingle().AsVector4());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits).AsSingle().AsVector4());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !(bool4 val) => new((val.Bits ^ Vector128<uint>.One).AsSingle().AsVector4());

    public bool this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<bool4, bool>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4) * 4);
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<bool4, bool>(ref this), Index.Checked(index, 4) * 4) = value;
    }

    public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

    public override bool Equals(object o) => o is bool4 rhs && Equals(rhs);

    public override int GetHashCode() => (x ? 1 : 0) | (y ? 2 : 0) | (z ? 4 : 0) | (w ? 8 : 0);

    public override string ToString() => $"bool4({x}, {y}, {z}, {w})";
}
