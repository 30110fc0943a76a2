using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 sin(float3 x) => new(sin(x.x), sin(x.y), sin(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 cos(float3 x) => new(cos(x.x), cos(x.y), cos(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 tan(float3 x) => new(tan(x.x), tan(x.y), tan(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 asin(float3 x) => new(asin(x.x), asin(x.y), asin(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 acos(float3 x) => new(acos(x.x), acos(x.y), acos(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 atan(float3 x) => new(atan(x.x), atan(x.y), atan(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 sinh(float3 x) => new(sinh(x.x), sinh(x.y), sinh(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 cosh(float3 x) => new(cosh(x.x), cosh(x.y), cosh(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 tanh(float3 x) => new(tanh(x.x), tanh(x.y), tanh(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 exp(float3 x) => new(exp(x.x), exp(x.y), exp(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 log(float3 x) => new(log(x.x), log(x.y), log(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 log2(float3 x) => new(log2(x.x), log2(x.y), log2(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 log10(float3 x) => new(log10(x.x), log10(x.y), log10(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 exp2(float3 x) => new(exp2(x.x), exp2(x.y), exp2(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 exp10(float3 x) => new(exp10(x.x), exp10(x.y), exp10(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 pow(float3 x, float3 y) => new(pow(x.x, y.x), pow(x.y, y.y), pow(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 atan2(float3 y, float3 x) => new(atan2(y.x, x.x), atan2(y.y, x.y), atan2(y.z, x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 fmod(float3 x, float3 y) => new(fmod(x.x, y.x), fmod(x.y, y.y), fmod(x.z, y.z));

    public static void sincos(float3 x, out float3 s, out float3 c)
    {
        sincos(x.x, out s.x, out c.x);
        sincos(x.y, out s.y, out c.y);
        sincos(x.z, out s.z, out c.z);
    }
}
