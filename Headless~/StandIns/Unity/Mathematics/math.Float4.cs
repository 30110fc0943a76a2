using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 abs(float4 x) => new() { lanes = Vector128.Abs(x.lanes) };

    // As in Unity, the second argument where both are zeros, on every processor.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 min(float4 x, float4 y) => Sse.IsSupported
        ? new(Vector128.ConditionalSelect(
            Vector128.IsNaN(y.lanes), x.lanes, Sse.Min(x.lanes, y.lanes)))
        : new(Vector128.ConditionalSelect(
            Vector128.IsNaN(y.lanes) | Vector128.LessThan(x.lanes, y.lanes), x.lanes, y.lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 max(float4 x, float4 y) => Sse.IsSupported
        ? new(Vector128.ConditionalSelect(
            Vector128.IsNaN(y.lanes), x.lanes, Sse.Max(x.lanes, y.lanes)))
        : new(Vector128.ConditionalSelect(
            Vector128.IsNaN(y.lanes) | Vector128.GreaterThan(x.lanes, y.lanes), x.lanes, y.lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 clamp(float4 valueToClamp, float4 lowerBound, float4 upperBound) =>
        max(min(valueToClamp, upperBound), lowerBound);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 saturate(float4 x) => max(min(x, new float4(1f)), new float4(0f));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 sqrt(float4 x) => new() { lanes = Vector128.Sqrt(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 rsqrt(float4 x) => new() { lanes = Vector128<float>.One / Vector128.Sqrt(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 rcp(float4 x) => new() { lanes = Vector128<float>.One / x.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 floor(float4 x) => new() { lanes = Vector128.Floor(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 ceil(float4 x) => new() { lanes = Vector128.Ceiling(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 round(float4 x) => new() { lanes = Vector128.Round(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 trunc(float4 x) => new() { lanes = Vector128.Truncate(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 frac(float4 x) => new() { lanes = x.lanes - Vector128.Floor(x.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 mad(float4 mulA, float4 mulB, float4 addC) => new() { lanes = mulA.lanes * mulB.lanes + addC.lanes };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 lerp(float4 start, float4 end, float t) => new() { lanes = start.lanes + (end.lanes - start.lanes) * t };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 lerp(float4 start, float4 end, float4 t) => new() { lanes = start.lanes + t.lanes * (end.lanes - start.lanes) };

    // Sums in Unity's order: those of Vector128 leave it to the processor.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float dot(float4 x, float4 y) => x.x * y.x + x.y * y.y + x.z * y.z + x.w * y.w;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float csum(float4 x) => (x.x + x.y) + (x.z + x.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 select(float4 falseValue, float4 trueValue, bool4 test) =>
        new() { lanes = test.Select(falseValue.lanes, trueValue.lanes) };

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 sign(float4 x) => select(0f, new float4(1f), x > 0f) - select(0f, new float4(1f), x < 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 isnan(float4 x) => new(Vector128.IsNaN(x.lanes).AsUInt32());

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 isfinite(float4 x) => abs(x) < INFINITY;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool4 isinf(float4 x) => abs(x) == INFINITY;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 select(float4 falseValue, float4 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 unlerp(float4 start, float4 end, float4 x) => (x - start) / (end - start);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 remap(float4 srcStart, float4 srcEnd, float4 dstStart, float4 dstEnd, float4 x) =>
        lerp(dstStart, dstEnd, unlerp(srcStart, srcEnd, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 step(float4 threshold, float4 x) => select(new float4(0f), new float4(1f), x >= threshold);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 smoothstep(float4 xMin, float4 xMax, float4 x)
    {
        float4 t = saturate((x - xMin) / (xMax - xMin));
        return t * t * (3f - 2f * t);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmin(float4 x) => min(min(x.x, x.y), min(x.z, x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float cmax(float4 x) => max(max(x.x, x.y), max(x.z, x.w));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool any(float4 x) => any(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool all(float4 x) => all(x != 0f);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float length(float4 x) => sqrt(dot(x, x));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float lengthsq(float4 x) => dot(x, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distance(float4 x, float4 y) => length(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float distancesq(float4 x, float4 y) => lengthsq(y - x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 normalize(float4 x) => rsqrt(dot(x, x)) * x;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 normalizesafe(float4 x, float4 defaultvalue = default)
    {
        float len = dot(x, x);
        return select(defaultvalue, x * rsqrt(len), len > FLT_MIN_NORMAL);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 reflect(float4 i, float4 n) => i - 2f * n * dot(i, n);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 project(float4 a, float4 ontoB) => dot(a, ontoB) / dot(ontoB, ontoB) * ontoB;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 degrees(float4 x) => x * 57.29577951308232f;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float4 radians(float4 x) => x * 0.017453292519943296f;
}
