using System;
using System.Collections.Generic;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Mathematics;

/// <summary>float4 runs on vector registers: each lane must be what the scalar function says, bit for bit.</summary>
public sealed class Float4Tests
{
    private static readonly float[] s_Special =
        [0f, 1f, -1f, 0.5f, -0.5f, 1.5f, 2.5f, -2.5f, 3.7f, 1e-30f, 1e30f, math.INFINITY, -math.INFINITY, math.NAN];

    private static IEnumerable<(float X, float Y)> Pairs()
    {
        foreach (float x in s_Special)
        {
            foreach (float y in s_Special)
                yield return (x, y);
        }

        var random = new Random(1);
        for (int i = 0; i < 200; i++)
            yield return (random.NextFloat(-9f, 9f), random.NextFloat(-9f, 9f));
    }

    private static void AssertLanes(string name, Func<float4, float4, float4> vector, Func<float, float, float> scalar)
    {
        foreach ((float x, float y) in Pairs())
        {
            float4 a = new(x, y, 1f, x), b = new(y, x, y, 2f);
            float4 result = vector(a, b);
            for (int i = 0; i < 4; i++)
                Assert.That(result[i], Is.EqualTo(scalar(a[i], b[i])), $"{name}({a[i]}, {b[i]}), lane {i}");
        }
    }

    [Test]
    public void Operators_WorkLaneByLane()
    {
        AssertLanes("+", (a, b) => a + b, (a, b) => a + b);
        AssertLanes("-", (a, b) => a - b, (a, b) => a - b);
        AssertLanes("*", (a, b) => a * b, (a, b) => a * b);
        AssertLanes("/", (a, b) => a / b, (a, b) => a / b);
        AssertLanes("%", (a, b) => a % b, (a, b) => a % b);
        AssertLanes("negation", (a, _) => -a, (a, _) => -a);
    }

    [Test]
    public void OperatorsWithAScalar_UseItInEachLane()
    {
        AssertLanes("v - s", (a, b) => new float4((a - b.x).x, (a - b.y).y, (a - b.z).z, (a - b.w).w), (a, b) => a - b);
        AssertLanes("s - v", (a, b) => new float4((b.x - a).x, (b.y - a).y, (b.z - a).z, (b.w - a).w), (a, b) => b - a);
        AssertLanes("s / v", (a, b) => new float4((b.x / a).x, (b.y / a).y, (b.z / a).z, (b.w / a).w), (a, b) => b / a);
        AssertLanes("s * v", (a, b) => new float4((b.x * a).x, (b.y * a).y, (b.z * a).z, (b.w * a).w), (a, b) => b * a);
    }

    [Test]
    public void Functions_AgreeWithTheScalarOnes()
    {
        AssertLanes("min", math.min, math.min);
        AssertLanes("max", math.max, math.max);
        AssertLanes("abs", (a, _) => math.abs(a), (a, _) => math.abs(a));
        AssertLanes("sqrt", (a, _) => math.sqrt(a), (a, _) => math.sqrt(a));
        AssertLanes("rsqrt", (a, _) => math.rsqrt(a), (a, _) => math.rsqrt(a));
        AssertLanes("rcp", (a, _) => math.rcp(a), (a, _) => math.rcp(a));
        AssertLanes("floor", (a, _) => math.floor(a), (a, _) => math.floor(a));
        AssertLanes("ceil", (a, _) => math.ceil(a), (a, _) => math.ceil(a));
        AssertLanes("round", (a, _) => math.round(a), (a, _) => math.round(a));
        AssertLanes("trunc", (a, _) => math.trunc(a), (a, _) => math.trunc(a));
        AssertLanes("frac", (a, _) => math.frac(a), (a, _) => math.frac(a));
        AssertLanes("sign", (a, _) => math.sign(a), (a, _) => math.sign(a));
        AssertLanes("saturate", (a, _) => math.saturate(a), (a, _) => math.saturate(a));
        AssertLanes("clamp", (a, _) => math.clamp(a, -2f, 3f), (a, _) => math.clamp(a, -2f, 3f));
        AssertLanes("mad", (a, b) => math.mad(a, b, 0.1f), (a, b) => math.mad(a, b, 0.1f));
        AssertLanes("lerp", (a, b) => math.lerp(a, b, new float4(0.3f)), (a, b) => math.lerp(a, b, 0.3f));
        AssertLanes("step", math.step, math.step);
        AssertLanes("smoothstep", (a, b) => math.smoothstep(-1f, 2f, a), (a, b) => math.smoothstep(-1f, 2f, a));
        AssertLanes("atan2", math.atan2, math.atan2);
        AssertLanes("exp", (a, _) => math.exp(a), (a, _) => math.exp(a));
    }

    [Test]
    public void Comparisons_AgreeWithTheScalarOnes_AndSelectByThem()
    {
        AssertLanes("<", (a, b) => math.select(a, b, a < b), (a, b) => a < b ? b : a);
        AssertLanes("<=", (a, b) => math.select(a, b, a <= b), (a, b) => a <= b ? b : a);
        AssertLanes(">", (a, b) => math.select(a, b, a > b), (a, b) => a > b ? b : a);
        AssertLanes(">=", (a, b) => math.select(a, b, a >= b), (a, b) => a >= b ? b : a);
        AssertLanes("==", (a, b) => math.select(-a, b, a == b), (a, b) => a == b ? b : -a);
        AssertLanes("!=", (a, b) => math.select(-a, b, a != b), (a, b) => a != b ? b : -a);
        AssertLanes("isnan", (a, b) => math.select(a, b, math.isnan(a)), (a, b) => math.isnan(a) ? b : a);
        AssertLanes("isfinite", (a, b) => math.select(a, b, math.isfinite(a)), (a, b) => math.isfinite(a) ? b : a);
        AssertLanes("isinf", (a, b) => math.select(a, b, math.isinf(a)), (a, b) => math.isinf(a) ? b : a);
    }

    [Test]
    public void SumsOverTheLanes_TakeAllFour()
    {
        var v = new float4(1f, 20f, 300f, 4000f);
        Assert.That(math.csum(v), Is.EqualTo(4321f));
        Assert.That(math.dot(v, new float4(1f, 2f, 3f, 4f)), Is.EqualTo(16941f));
        Assert.That(math.cmin(-v), Is.EqualTo(-4000f));
        Assert.That(math.cmax(v), Is.EqualTo(4000f));
        Assert.That(math.length(new float4(1f, 1f, 1f, 1f)), Is.EqualTo(2f));
    }

    [Test]
    public void FieldsAndLanes_AreTheSameMemory()
    {
        var v = new float4(1f, 2f, 3f, 4f);
        v.y = 7f;
        v[3] = 9f;
        v.xz = new float2(5f, 6f);
        Assert.That(v * 2f, Is.EqualTo(new float4(10f, 14f, 12f, 18f)));
        Assert.That(v.wzyx, Is.EqualTo(new float4(9f, 6f, 7f, 5f)));
    }

    [Test]
    public unsafe void Vectors_AreAsLargeAsInUnity()
    {
        Assert.That(sizeof(float4), Is.EqualTo(16));
        Assert.That(sizeof(int4), Is.EqualTo(16));
        Assert.That(sizeof(float3), Is.EqualTo(12));
        Assert.That(sizeof(quaternion), Is.EqualTo(16));
        Assert.That(sizeof(float4x4), Is.EqualTo(64));
        Assert.That(Unity.Collections.LowLevel.Unsafe.UnsafeUtility.AlignOf<float4>(), Is.EqualTo(4));
    }

    [Test]
    public void Indexer_RefusesWhatIsNoLane()
    {
        TestBuild.RequireChecks();
        Assert.That(() => new float4(1f)[4], Throws.ArgumentException);
        Assert.That(() => new float3(1f)[-1], Throws.ArgumentException);
    }
}
