using System;
using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double abs(double x) => Math.Abs(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double min(double x, double y) => double.IsNaN(y) || x < y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double max(double x, double y) => double.IsNaN(y) || x > y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double clamp(double valueToClamp, double lowerBound, double upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double saturate(double x) => clamp(x, 0.0, 1.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double lerp(double start, double end, double t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double unlerp(double start, double end, double x) => (x - start) / (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double remap(double srcStart, double srcEnd, double dstStart, double dstEnd, double x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double mad(double mulA, double mulB, double addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double dot(double x, double y) => x * y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double sqrt(double x) => Math.Sqrt(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double rsqrt(double x) => 1.0 / Math.Sqrt(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double rcp(double x) => 1.0 / x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double floor(double x) => Math.Floor(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double ceil(double x) => Math.Ceiling(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double round(double x) => Math.Round(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double trunc(double x) => Math.Truncate(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double frac(double x) => x - Math.Floor(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double sign(double x) => (x > 0.0 ? 1.0 : 0.0) - (x < 0.0 ? 1.0 : 0.0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double sin(double x) => Math.Sin(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double cos(double x) => Math.Cos(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double tan(double x) => Math.Tan(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double asin(double x) => Math.Asin(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double acos(double x) => Math.Acos(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double atan(double x) => Math.Atan(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double sinh(double x) => Math.Sinh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double cosh(double x) => Math.Cosh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double tanh(double x) => Math.Tanh(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double exp(double x) => Math.Exp(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double log(double x) => Math.Log(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double log2(double x) => Math.Log2(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double log10(double x) => Math.Log10(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double exp2(double x) => Math.Pow(2.0, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double exp10(double x) => Math.Pow(10.0, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double pow(double x, double y) => Math.Pow(x, y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double atan2(double y, double x) => Math.Atan2(y, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double fmod(double x, double y) => x % y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double degrees(double x) => x * 57.29577951308232;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double radians(double x) => x * 0.017453292519943296;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double step(double threshold, double x) => x >= threshold ? 1.0 : 0.0;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double smoothstep(double xMin, double xMax, double x)
    {
        double t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3 - 2 * t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double length(double x) => Math.Abs(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double lengthsq(double x) => x * x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double distance(double x, double y) => Math.Abs(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double distancesq(double x, double y) => (y - x) * (y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static double select(double falseValue, double trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isfinite(double x) => double.IsFinite(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isinf(double x) => double.IsInfinity(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool isnan(double x) => double.IsNaN(x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void sincos(double x, out double s, out double c)
    {
        (s, c) = Math.SinCos(x);
    }
}
