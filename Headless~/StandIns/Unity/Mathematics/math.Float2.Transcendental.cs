using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 sin(float2 x) => new(sin(x.x), sin(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 cos(float2 x) => new(cos(x.x), cos(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 tan(float2 x) => new(tan(x.x), tan(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 asin(float2 x) => new(asin(x.x), asin(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 acos(float2 x) => new(acos(x.x), acos(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 atan(float2 x) => new(atan(x.x), atan(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 sinh(float2 x) => new(sinh(x.x), sinh(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 cosh(float2 x) => new(cosh(x.x), cosh(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 tanh(float2 x) => new(tanh(x.x), tanh(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 exp(float2 x) => new(exp(x.x), exp(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 log(float2 x) => new(log(x.x), log(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 log2(float2 x) => new(log2(x.x), log2(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 log10(float2 x) => new(log10(x.x), log10(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 exp2(float2 x) => new(exp2(x.x), exp2(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 exp10(float2 x) => new(exp10(x.x), exp10(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 pow(float2 x, float2 y) => new(pow(x.x, y.x), pow(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 atan2(float2 y, float2 x) => new(atan2(y.x, x.x), atan2(y.y, x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 fmod(float2 x, float2 y) => new(fmod(x.x, y.x), fmod(x.y, y.y));

    public static void sincos(float2 x, out float2 s, out float2 c)
    {
        sincos(x.x, out s.x, out c.x);
        sincos(x.y, out s.y, out c.y);
    }
}
