using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Unity.Mathematics;

/// <summary>
/// Four truth values. Each is a lane of a vector register: true has its lowest bit, which the field shows, and its highest, which selects.
/// </summary>
[StructLayout(LayoutKind.Explicit, Size = 16, Pack = 4)]
public partial struct bool4 : IEquatable<bool4>
{
    private const uint k_True = 0x80000001u;

    // Read-only, unlike Unity's: writing one would leave the highest bit as it was. The indexer can write.
    [FieldOffset(0)] public readonly bool x;
    [FieldOffset(4)] public readonly bool y;
    [FieldOffset(8)] public readonly bool z;
    [FieldOffset(12)] public readonly bool w;
    [FieldOffset(0)] internal readonly Vector128<float> lanes;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool y, bool z, bool w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(x), Lane(y), Lane(z), Lane(w)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool y, bool2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(x), Lane(y), Lane(zw.x), Lane(zw.y)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool2 yz, bool w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(x), Lane(yz.x), Lane(yz.y), Lane(w)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool x, bool3 yzw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(x), Lane(yzw.x), Lane(yzw.y), Lane(yzw.z)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool2 xy, bool z, bool w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(xy.x), Lane(xy.y), Lane(z), Lane(w)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool2 xy, bool2 zw)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(xy.x), Lane(xy.y), Lane(zw.x), Lane(zw.y)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool3 xyz, bool w)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(xyz.x), Lane(xyz.y), Lane(xyz.z), Lane(w)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool4(bool v)
    {
        Unsafe.SkipInit(out this);
        lanes = Vector128.Create(Lane(v)).AsSingle();
    }

    // From a mask whose lanes are all zeros or all ones.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal bool4(Vector128<uint> mask)
    {
        Unsafe.SkipInit(out this);
        lanes = (mask & Vector128.Create(k_True)).AsSingle();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private bool4(Vector128<float> lanes)
    {
        Unsafe.SkipInit(out this);
        this.lanes = lanes;
    }

    internal Vector128<uint> Bits
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => lanes.AsUInt32();
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static uint Lane(bool v) => v ? k_True : 0u;

    /// <summary>Lanes of onTrue where true, else of onFalse.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal Vector128<float> Select(Vector128<float> onFalse, Vector128<float> onTrue) => Sse41.IsSupported
        ? Sse41.BlendVariable(onFalse, onTrue, lanes)
        : Vector128.ConditionalSelect((lanes.AsInt32() >> 31).AsSingle(), onTrue, onFalse);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator bool4(bool v) => new(v);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator &(bool4 lhs, bool4 rhs) => new((lhs.Bits & rhs.Bits).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator |(bool4 lhs, bool4 rhs) => new((lhs.Bits | rhs.Bits).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ^(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator ==(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits ^ Vector128.Create(k_True)).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !=(bool4 lhs, bool4 rhs) => new((lhs.Bits ^ rhs.Bits).AsSingle());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 operator !(bool4 val) => new((val.Bits ^ Vector128.Create(k_True)).AsSingle());

    public bool this[int index]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Unsafe.Add(ref Unsafe.As<bool4, uint>(ref Unsafe.AsRef(in this)), Index.Checked(index, 4)) != 0u;
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        set => Unsafe.Add(ref Unsafe.As<bool4, uint>(ref this), Index.Checked(index, 4)) = Lane(value);
    }

    public bool Equals(bool4 rhs) => x == rhs.x && y == rhs.y && z == rhs.z && w == rhs.w;

    public override bool Equals(object o) => o is bool4 rhs && Equals(rhs);

    public override int GetHashCode() => (x ? 1 : 0) | (y ? 2 : 0) | (z ? 4 : 0) | (w ? 8 : 0);

    public override string ToString() => $"bool4({x}, {y}, {z}, {w})";
}
