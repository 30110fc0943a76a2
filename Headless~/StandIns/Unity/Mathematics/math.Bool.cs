using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(bool2 x) => x.x || x.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(bool2 x) => x.x && x.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(bool3 x) => x.x || x.y || x.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(bool3 x) => x.x && x.y && x.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(bool4 x) => x.Bits != Vector128<uint>.Zero;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(bool4 x) => Vector128.ExtractMostSignificantBits(x.Bits) == 15u;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int bitmask(bool4 value) => (int)Vector128.ExtractMostSignificantBits(value.Bits);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(int2 x) => any(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(int2 x) => all(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(uint2 x) => any(x != 0u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(uint2 x) => all(x != 0u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(int3 x) => any(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(int3 x) => all(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(uint3 x) => any(x != 0u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(uint3 x) => all(x != 0u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(int4 x) => any(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(int4 x) => all(x != 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(uint4 x) => any(x != 0u);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(uint4 x) => all(x != 0u);
}
