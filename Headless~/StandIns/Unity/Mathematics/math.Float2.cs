using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 abs(float2 x) => new(abs(x.x), abs(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 sqrt(float2 x) => new(sqrt(x.x), sqrt(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 rsqrt(float2 x) => new(rsqrt(x.x), rsqrt(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 rcp(float2 x) => new(rcp(x.x), rcp(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 floor(float2 x) => new(floor(x.x), floor(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 ceil(float2 x) => new(ceil(x.x), ceil(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 round(float2 x) => new(round(x.x), round(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 trunc(float2 x) => new(trunc(x.x), trunc(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 frac(float2 x) => new(frac(x.x), frac(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 sign(float2 x) => new(sign(x.x), sign(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 saturate(float2 x) => new(saturate(x.x), saturate(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 min(float2 x, float2 y) => new(min(x.x, y.x), min(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 max(float2 x, float2 y) => new(max(x.x, y.x), max(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 clamp(float2 valueToClamp, float2 lowerBound, float2 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 mad(float2 mulA, float2 mulB, float2 addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 lerp(float2 start, float2 end, float t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 lerp(float2 start, float2 end, float2 t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float dot(float2 x, float2 y) => x.x * y.x + x.y * y.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float csum(float2 x) => x.x + x.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 select(float2 falseValue, float2 trueValue, bool2 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 isnan(float2 x) => new(isnan(x.x), isnan(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 isfinite(float2 x) => new(isfinite(x.x), isfinite(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool2 isinf(float2 x) => new(isinf(x.x), isinf(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 select(float2 falseValue, float2 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 unlerp(float2 start, float2 end, float2 x) => (x - start) / (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 remap(float2 srcStart, float2 srcEnd, float2 dstStart, float2 dstEnd, float2 x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 step(float2 threshold, float2 x) => select(new float2(0f), new float2(1f), x >= threshold);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 smoothstep(float2 xMin, float2 xMax, float2 x)
    {
        float2 t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3f - 2f * t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmin(float2 x) => min(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmax(float2 x) => max(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(float2 x) => any(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(float2 x) => all(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float length(float2 x) => sqrt(dot(x, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lengthsq(float2 x) => dot(x, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distance(float2 x, float2 y) => length(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distancesq(float2 x, float2 y) => lengthsq(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 normalize(float2 x) => rsqrt(dot(x, x)) * x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 normalizesafe(float2 x, float2 defaultvalue = default)
    {
        float len = dot(x, x);
        return select(defaultvalue, x * rsqrt(len), len > FLT_MIN_NORMAL);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 reflect(float2 i, float2 n) => i - 2f * n * dot(i, n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 project(float2 a, float2 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 degrees(float2 x) => x * 57.29577951308232f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float2 radians(float2 x) => x * 0.017453292519943296f;
}
