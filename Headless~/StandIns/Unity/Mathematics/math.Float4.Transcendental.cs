using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 sin(float4 x) => new(sin(x.x), sin(x.y), sin(x.z), sin(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 cos(float4 x) => new(cos(x.x), cos(x.y), cos(x.z), cos(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 tan(float4 x) => new(tan(x.x), tan(x.y), tan(x.z), tan(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 asin(float4 x) => new(asin(x.x), asin(x.y), asin(x.z), asin(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 acos(float4 x) => new(acos(x.x), acos(x.y), acos(x.z), acos(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 atan(float4 x) => new(atan(x.x), atan(x.y), atan(x.z), atan(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 sinh(float4 x) => new(sinh(x.x), sinh(x.y), sinh(x.z), sinh(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 cosh(float4 x) => new(cosh(x.x), cosh(x.y), cosh(x.z), cosh(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 tanh(float4 x) => new(tanh(x.x), tanh(x.y), tanh(x.z), tanh(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 exp(float4 x) => new(exp(x.x), exp(x.y), exp(x.z), exp(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 log(float4 x) => new(log(x.x), log(x.y), log(x.z), log(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 log2(float4 x) => new(log2(x.x), log2(x.y), log2(x.z), log2(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 log10(float4 x) => new(log10(x.x), log10(x.y), log10(x.z), log10(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 exp2(float4 x) => new(exp2(x.x), exp2(x.y), exp2(x.z), exp2(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 exp10(float4 x) => new(exp10(x.x), exp10(x.y), exp10(x.z), exp10(x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 pow(float4 x, float4 y) => new(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z), pow(x.w, y.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 atan2(float4 y, float4 x) => new(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z), atan2(y.w, x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 fmod(float4 x, float4 y) => new(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z), fmod(x.w, y.w));

    public static void sincos(float4 x, out float4 s, out float4 c)
    {
        Unsafe.SkipInit(out s);
        Unsafe.SkipInit(out c);
        sincos(x.x, out s.x, out c.x);
        sincos(x.y, out s.y, out c.y);
        sincos(x.z, out s.z, out c.z);
        sincos(x.w, out s.w, out c.w);
    }
}
