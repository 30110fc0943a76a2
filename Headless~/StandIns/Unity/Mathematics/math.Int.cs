using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Unity.Mathematics;

public static partial class @math
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int abs(int x) => max(-x, x);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int min(int x, int y) => x < y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int max(int x, int y) => x > y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int clamp(int valueToClamp, int lowerBound, int upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int select(int falseValue, int trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int mad(int mulA, int mulB, int addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 abs(int2 x) => new(abs(x.x), abs(x.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 min(int2 x, int2 y) => new(min(x.x, y.x), min(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 max(int2 x, int2 y) => new(max(x.x, y.x), max(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 select(int2 falseValue, int2 trueValue, bool2 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 select(int2 falseValue, int2 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int2 clamp(int2 valueToClamp, int2 lowerBound, int2 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int csum(int2 x) => x.x + x.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmin(int2 x) => min(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmax(int2 x) => max(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 abs(int3 x) => new(abs(x.x), abs(x.y), abs(x.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 min(int3 x, int3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 max(int3 x, int3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 select(int3 falseValue, int3 trueValue, bool3 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y, test.z ? trueValue.z : falseValue.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 select(int3 falseValue, int3 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int3 clamp(int3 valueToClamp, int3 lowerBound, int3 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int csum(int3 x) => x.x + x.y + x.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmin(int3 x) => min(min(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmax(int3 x) => max(max(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 abs(int4 x) => new(Vector128.Abs(x.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 min(int4 x, int4 y) => new(Vector128.Min(x.V, y.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 max(int4 x, int4 y) => new(Vector128.Max(x.V, y.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 select(int4 falseValue, int4 trueValue, bool4 test) =>
        new(test.Select(falseValue.lanes, trueValue.lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 select(int4 falseValue, int4 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int4 clamp(int4 valueToClamp, int4 lowerBound, int4 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int csum(int4 x) => x.x + x.y + x.z + x.w;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmin(int4 x) => min(min(min(x.x, x.y), x.z), x.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int cmax(int4 x) => max(max(max(x.x, x.y), x.z), x.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint min(uint x, uint y) => x < y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint max(uint x, uint y) => x > y ? x : y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint clamp(uint valueToClamp, uint lowerBound, uint upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint select(uint falseValue, uint trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint mad(uint mulA, uint mulB, uint addC) => mulA * mulB + addC;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 min(uint2 x, uint2 y) => new(min(x.x, y.x), min(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 max(uint2 x, uint2 y) => new(max(x.x, y.x), max(x.y, y.y));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 select(uint2 falseValue, uint2 trueValue, bool2 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 select(uint2 falseValue, uint2 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint2 clamp(uint2 valueToClamp, uint2 lowerBound, uint2 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint csum(uint2 x) => x.x + x.y;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmin(uint2 x) => min(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmax(uint2 x) => max(x.x, x.y);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 min(uint3 x, uint3 y) => new(min(x.x, y.x), min(x.y, y.y), min(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 max(uint3 x, uint3 y) => new(max(x.x, y.x), max(x.y, y.y), max(x.z, y.z));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 select(uint3 falseValue, uint3 trueValue, bool3 test) =>
        new(test.x ? trueValue.x : falseValue.x, test.y ? trueValue.y : falseValue.y, test.z ? trueValue.z : falseValue.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 select(uint3 falseValue, uint3 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint3 clamp(uint3 valueToClamp, uint3 lowerBound, uint3 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint csum(uint3 x) => x.x + x.y + x.z;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmin(uint3 x) => min(min(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmax(uint3 x) => max(max(x.x, x.y), x.z);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 min(uint4 x, uint4 y) => new(Vector128.Min(x.V, y.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 max(uint4 x, uint4 y) => new(Vector128.Max(x.V, y.V));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 select(uint4 falseValue, uint4 trueValue, bool4 test) =>
        new(test.Select(falseValue.lanes, trueValue.lanes));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 select(uint4 falseValue, uint4 trueValue, bool test) => test ? trueValue : falseValue;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint4 clamp(uint4 valueToClamp, uint4 lowerBound, uint4 upperBound) => max(lowerBound, min(upperBound, valueToClamp));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint csum(uint4 x) => x.x + x.y + x.z + x.w;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmin(uint4 x) => min(min(min(x.x, x.y), x.z), x.w);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint cmax(uint4 x) => max(max(max(x.x, x.y), x.z), x.w);
}
