using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float abs(float x) => MathF.Abs(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float min(float x, float y) => float.IsNaN(y) || x < y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float max(float x, float y) => float.IsNaN(y) || x > y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float clamp(float valueToClamp, float lowerBound, float upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float saturate(float x) => clamp(x, 0f, 1f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lerp(float start, float end, float t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float unlerp(float start, float end, float x) => (x - start) / (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float remap(float srcStart, float srcEnd, float dstStart, float dstEnd, float x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float mad(float mulA, float mulB, float addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float dot(float x, float y) => x * y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float sqrt(float x) => MathF.Sqrt(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float rsqrt(float x) => 1f / MathF.Sqrt(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float rcp(float x) => 1f / x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float floor(float x) => MathF.Floor(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float ceil(float x) => MathF.Ceiling(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float round(float x) => MathF.Round(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float trunc(float x) => MathF.Truncate(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float frac(float x) => x - MathF.Floor(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float sign(float x) => (x > 0f ? 1f : 0f) - (x < 0f ? 1f : 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float sin(float x) => MathF.Sin(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cos(float x) => MathF.Cos(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float tan(float x) => MathF.Tan(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float asin(float x) => MathF.Asin(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float acos(float x) => MathF.Acos(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float atan(float x) => MathF.Atan(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float sinh(float x) => MathF.Sinh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cosh(float x) => MathF.Cosh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float tanh(float x) => MathF.Tanh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float exp(float x) => MathF.Exp(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float log(float x) => MathF.Log(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float log2(float x) => MathF.Log2(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float log10(float x) => MathF.Log10(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float exp2(float x) => MathF.Pow(2f, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float exp10(float x) => MathF.Pow(10f, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float pow(float x, float y) => MathF.Pow(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float atan2(float y, float x) => MathF.Atan2(y, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float fmod(float x, float y) => x % y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float degrees(float x) => x * 57.29577951308232f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float radians(float x) => x * 0.017453292519943296f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float step(float threshold, float x) => x >= threshold ? 1f : 0f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float smoothstep(float xMin, float xMax, float x)
    {
        float t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3f - 2f * t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float length(float x) => MathF.Abs(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lengthsq(float x) => x * x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distance(float x, float y) => MathF.Abs(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distancesq(float x, float y) => (y - x) * (y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float select(float falseValue, float trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isfinite(float x) => float.IsFinite(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isinf(float x) => float.IsInfinity(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isnan(float x) => float.IsNaN(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void sincos(float x, out float s, out float c)
    {
        (s, c) = MathF.SinCos(x);
    }
}
