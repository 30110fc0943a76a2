using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Unity.Tests.Mathematics;

public sealed class RandomTests
{
    // Marsaglia, Xorshift RNGs (2003), shifts 13, 17, 5, from 1 on.
    private static readonly uint[] s_Xorshift = [270369u, 67634689u, 2647435461u, 307599695u, 2398689233u];

    [Test]
    public void States_AreMarsagliasXorshift()
    {
        var random = new Random(1u);
        foreach (uint state in s_Xorshift)
        {
            Assert.That(random.state, Is.EqualTo(state));
            Assert.That(random.NextUInt(), Is.EqualTo(state - 1u));
        }
    }

    [Test]
    public void Numbers_LieInTheirRange()
    {
        var random = Random.CreateFromIndex(0u);
        float sum = 0f;
        for (int i = 0; i < 10000; i++)
        {
            float f = random.NextFloat(-2f, 3f);
            int n = random.NextInt(-3, 4);
            Assert.That(f, Is.InRange(-2f, 3f));
            Assert.That(n, Is.InRange(-3, 3));
            sum += f;
        }

        Assert.That(sum / 10000f, Is.EqualTo(0.5f).Within(0.05f));
    }

    [Test]
    public void Directions_HaveUnitLength()
    {
        var random = new Random(77u);
        for (int i = 0; i < 100; i++)
        {
            Assert.That(math.length(random.NextFloat3Direction()), Is.EqualTo(1f).Within(1e-6f));
            Assert.That(math.length(random.NextQuaternionRotation()), Is.EqualTo(1f).Within(1e-6f));
        }
    }

    [Test]
    public void ASeedOfZero_IsRefused()
    {
        TestBuild.RequireChecks();
        Assert.That(() => new Random(0u), Throws.ArgumentException);
    }
}
