using NUnit.Framework;
using Unity.Mathematics;

namespace Unity.Tests.Mathematics;

public sealed class Bool4Tests
{
    private static bool4 FromBits(int bits) => new((bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0);

    // The same truth values, made by a comparison.
    private static bool4 Compared(int bits) => new float4(bits & 1, bits & 2, bits & 4, bits & 8) > 0f;

    [Test]
    public void EveryCombination_IsTheSame_HoweverItWasMade([Range(0, 15)] int bits)
    {
        bool4 made = FromBits(bits), compared = Compared(bits);
        Assert.That(compared, Is.EqualTo(made));
        Assert.That(math.bitmask(compared), Is.EqualTo(bits));
        Assert.That(math.any(compared), Is.EqualTo(bits != 0));
        Assert.That(math.all(compared), Is.EqualTo(bits == 15));
        for (int i = 0; i < 4; i++)
            Assert.That(compared[i], Is.EqualTo((bits >> i & 1) != 0));
        Assert.That(compared.x, Is.EqualTo((bits & 1) != 0));
        Assert.That(compared.w, Is.EqualTo((bits & 8) != 0));
    }

    [Test]
    public void Operators_FollowTheTruthTable([Range(0, 15)] int left, [Range(0, 15)] int right)
    {
        bool4 a = FromBits(left), b = Compared(right);
        Assert.That(math.bitmask(a & b), Is.EqualTo(left & right));
        Assert.That(math.bitmask(a | b), Is.EqualTo(left | right));
        Assert.That(math.bitmask(a ^ b), Is.EqualTo(left ^ right));
        Assert.That(math.bitmask(!a), Is.EqualTo(~left & 15));
        Assert.That(math.bitmask(a == b), Is.EqualTo(~(left ^ right) & 15));
        Assert.That(math.bitmask(a != b), Is.EqualTo(left ^ right));
    }

    [Test]
    public void Select_TakesTheSecond_WhereTrue_AfterAnyOperator([Range(0, 15)] int bits)
    {
        float4 onFalse = -1f, onTrue = new(1f, 2f, 3f, 4f);
        var expected = new float4(
            (bits & 1) != 0 ? 1f : -1f, (bits & 2) != 0 ? 2f : -1f, (bits & 4) != 0 ? 3f : -1f, (bits & 8) != 0 ? 4f : -1f);
        bool4 indexed = false;
        for (int i = 0; i < 4; i++)
            indexed[i] = (bits >> i & 1) != 0;
        Assert.That(math.select(onFalse, onTrue, FromBits(bits)), Is.EqualTo(expected));
        Assert.That(math.select(onFalse, onTrue, Compared(bits)), Is.EqualTo(expected));
        Assert.That(math.select(onFalse, onTrue, !!Compared(bits)), Is.EqualTo(expected));
        Assert.That(math.select(onFalse, onTrue, Compared(bits) == true), Is.EqualTo(expected));
        Assert.That(math.select(onFalse, onTrue, indexed), Is.EqualTo(expected));
        Assert.That(math.select(new int4(-1), new int4(1, 2, 3, 4), Compared(bits)), Is.EqualTo((int4)expected));
    }
}
