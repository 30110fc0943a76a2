using Alate.Flight;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Flight
{
    public sealed class HeadingsTests
    {
        [TestCase(0f, 0f)]
        [TestCase(1f, 1f)]
        [TestCase(-3f, -3f)]
        [TestCase(4f, 4f - 2f * math.PI)]
        [TestCase(-4f, 2f * math.PI - 4f)]
        [TestCase(20f, 20f - 6f * math.PI)]
        public void Wrap_TakesWholeTurnsAway(float angle, float expected) =>
            Assert.That(Headings.Wrap(angle), Is.EqualTo(expected).Within(1e-5f));

        [TestCase(0f)]
        [TestCase(1f)]
        [TestCase(-3f)]
        public void Of_IsTheTurnFromZTowardsX_WhateverThePitch(float heading) =>
            Assert.That(Headings.Of(math.mul(quaternion.RotateY(heading), quaternion.RotateX(0.5f))), Is.EqualTo(heading).Within(1e-5f));
    }
}
