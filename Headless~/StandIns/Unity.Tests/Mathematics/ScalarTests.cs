using NUnit.Framework;
using Unity.Mathematics;

namespace Unity.Tests.Mathematics;

public sealed class ScalarTests
{
    [Test]
    public void MinAndMax_LeaveOutNaN()
    {
        Assert.That(math.min(math.NAN, 2f), Is.EqualTo(2f));
        Assert.That(math.min(2f, math.NAN), Is.EqualTo(2f));
        Assert.That(math.max(math.NAN, 2f), Is.EqualTo(2f));
        Assert.That(math.max(2f, math.NAN), Is.EqualTo(2f));
        Assert.That(math.min(math.NAN, math.NAN), Is.NaN);
    }

    [Test]
    public void Round_GoesToTheEvenNumber_FromTheMiddle()
    {
        Assert.That(math.round(new float4(0.5f, 1.5f, 2.5f, -0.5f)), Is.EqualTo(new float4(0f, 2f, 2f, 0f)));
        Assert.That(math.round(-1.5f), Is.EqualTo(-2f));
    }

    [Test]
    public void Frac_IsNeverNegative() => Assert.That(math.frac(-0.25f), Is.EqualTo(0.75f));

    [Test]
    public void Fmod_KeepsTheSignOfTheDividend() => Assert.That(math.fmod(-5.5f, 2f), Is.EqualTo(-1.5f));

    [Test]
    public void Select_TakesTheSecondIfTrue()
    {
        Assert.That(math.select(1f, 2f, true), Is.EqualTo(2f));
        Assert.That(math.select(1, 2, false), Is.EqualTo(1));
    }

    [Test]
    public void Sign_OfZeroIsZero() => Assert.That(math.sign(new float3(-3f, 0f, 4f)), Is.EqualTo(new float3(-1f, 0f, 1f)));

    [Test]
    public void NormalizeSafe_GivesTheDefault_ForAVectorWithoutLength()
    {
        Assert.That(math.normalizesafe(new float3(0f)), Is.EqualTo(new float3(0f)));
        Assert.That(math.normalizesafe(new float3(1e-30f), new float3(0f, 1f, 0f)), Is.EqualTo(new float3(0f, 1f, 0f)));
        Assert.That(math.normalizesafe(new float3(0f, 0f, -4f)), Is.EqualTo(new float3(0f, 0f, -1f)));
    }

    [Test]
    public void Cross_OfXAndY_IsZ()
    {
        Assert.That(math.cross(new float3(1f, 0f, 0f), new float3(0f, 1f, 0f)), Is.EqualTo(new float3(0f, 0f, 1f)));
    }

    [Test]
    public void Smoothstep_RisesFromZeroToOne_AndStaysThere()
    {
        Assert.That(math.smoothstep(2f, 4f, 1f), Is.EqualTo(0f));
        Assert.That(math.smoothstep(2f, 4f, 3f), Is.EqualTo(0.5f));
        Assert.That(math.smoothstep(2f, 4f, 2.5f), Is.EqualTo(0.15625f));
        Assert.That(math.smoothstep(2f, 4f, 5f), Is.EqualTo(1f));
    }

    [Test]
    public void Bits_GoThereAndBack()
    {
        Assert.That(math.asuint(1f), Is.EqualTo(0x3f800000u));
        Assert.That(math.asint(new float4(-2f)), Is.EqualTo(new int4(unchecked((int)0xc0000000))));
        Assert.That(math.asfloat(math.asuint(new float3(1.5f, -2f, 1e-20f))), Is.EqualTo(new float3(1.5f, -2f, 1e-20f)));
    }

    [Test]
    public void Integers_ConvertByCuttingOff()
    {
        Assert.That((int4)new float4(1.9f, -1.9f, 0.5f, 1e6f), Is.EqualTo(new int4(1, -1, 0, 1000000)));
        Assert.That((int3)new float3(1.9f, -1.9f, 0.5f), Is.EqualTo(new int3(1, -1, 0)));
        float4 back = new int4(1, -2, 3, 16777216);
        Assert.That(back, Is.EqualTo(new float4(1f, -2f, 3f, 16777216f)));
    }

    [Test]
    public void Text_IsAsInUnity()
    {
        Assert.That(new float3(1f, 2.5f, -3f).ToString(), Is.EqualTo("float3(1f, 2.5f, -3f)"));
        Assert.That(new quaternion(0f, 0f, 0f, 1f).ToString(), Is.EqualTo("quaternion(0f, 0f, 0f, 1f)"));
        Assert.That(new int2(1, 2).ToString(), Is.EqualTo("int2(1, 2)"));
    }
}
