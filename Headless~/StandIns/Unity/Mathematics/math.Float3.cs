using System.Runtime.CompilerServices;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 abs(float3 x) => new(abs(x.x), abs(x.y), abs(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 sqrt(float3 x) => new(sqrt(x.x), sqrt(x.y), sqrt(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 rsqrt(float3 x) => new(rsqrt(x.x), rsqrt(x.y), rsqrt(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 rcp(float3 x) => new(rcp(x.x), rcp(x.y), rcp(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 floor(float3 x) => new(floor(x.x), floor(x.y), floor(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 ceil(float3 x) => new(ceil(x.x), ceil(x.y), ceil(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 round(float3 x) => new(round(x.x), round(x.y), round(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 trunc(float3 x) => new(trunc(x.x), trunc(x.y), trunc(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 frac(float3 x) => new(frac(x.x), frac(x.y), frac(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 sign(float3 x) => new(sign(x.x), sign(x.y), sign(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 saturate(float3 x) => new(saturate(x.x), saturate(x.y), saturate(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 min(float3 x, float3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 max(float3 x, float3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 clamp(float3 valueToClamp, float3 lowerBound, float3 upperBound) =>
        max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 mad(float3 mulA, float3 mulB, float3 addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 lerp(float3 start, float3 end, float t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 lerp(float3 start, float3 end, float3 t) => start + t * (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float dot(float3 x, float3 y) => x.x * y.x + x.y * y.y + x.z * y.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float csum(float3 x) => x.x + x.y + x.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 select(float3 falseValue, float3 trueValue, bool3 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y, test.z ? trueValue.z : falseValue.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 isnan(float3 x) => new(isnan(x.x), isnan(x.y), isnan(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 isfinite(float3 x) => new(isfinite(x.x), isfinite(x.y), isfinite(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool3 isinf(float3 x) => new(isinf(x.x), isinf(x.y), isinf(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 select(float3 falseValue, float3 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 unlerp(float3 start, float3 end, float3 x) => (x - start) / (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 remap(float3 srcStart, float3 srcEnd, float3 dstStart, float3 dstEnd, float3 x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 step(float3 threshold, float3 x) => select(new float3(0f), new float3(1f), x >= threshold);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 smoothstep(float3 xMin, float3 xMax, float3 x)
    {
        float3 t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3f - 2f * t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmin(float3 x) => min(min(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmax(float3 x) => max(max(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(float3 x) => any(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(float3 x) => all(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float length(float3 x) => sqrt(dot(x, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lengthsq(float3 x) => dot(x, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distance(float3 x, float3 y) => length(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distancesq(float3 x, float3 y) => lengthsq(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 normalize(float3 x) => rsqrt(dot(x, x)) * x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 normalizesafe(float3 x, float3 defaultvalue = default)
    {
        float len = dot(x, x);
        return select(defaultvalue, x * rsqrt(len), len > FLT_MIN_NORMAL);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 reflect(float3 i, float3 n) => i - 2f * n * dot(i, n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 project(float3 a, float3 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 degrees(float3 x) => x * 57.29577951308232f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 radians(float3 x) => x * 0.017453292519943296f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float3 cross(float3 x, float3 y) => new(x.y * y.z - x.z * y.y, x.z * y.x - x.x * y.z, x.x * y.y - x.y * y.x);
}
