using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class BendingTests
    {
        [Test]
        public void Hinge_TakesTheCheckedImplicitStep()
        {
            float4 rate = -1f;
            Bending.Hinge(0.01f, 0.2f, 0.05f, 5f, 0.3f, math.radians(30f), 0.004f, rate, 0.02f, ref rate);
            Assert.That(rate.x, Is.EqualTo(-0.848375).Within(0.848375 * Lanes.CheckTolerance));
        }

        [Test]
        public void Hinge_StopsAtItsLimit_AndDropsTheOutwardRate()
        {
            float4 rate = 10f;
            float4 angle = Bending.Hinge(0.01f, 0.2f, 0f, 5f, 30f, math.radians(30f), 0.02f, rate, 0.5f, ref rate);
            Assert.That(angle.x, Is.EqualTo(0.523599).Within(0.523599 * Lanes.CheckTolerance));
            Assert.That(rate.x, Is.Zero);
        }

        [Test]
        public void Hinge_AtItsLimit_MayComeBack()
        {
            float4 rate = -10f;
            float4 angle = Bending.Hinge(0.01f, 0f, 0f, 0f, 0f, math.radians(30f), 0.01f, rate, math.radians(30f), ref rate);
            Assert.That(angle.x, Is.LessThan(math.radians(30f)));
            Assert.That(rate.x, Is.EqualTo(-10f).Within(1e-4f));
        }

        [Test]
        public void Hinge_SettlesWhereTorqueMeetsStiffness()
        {
            float4 rate = 0f, angle = 0f;
            for (int k = 0; k < 2000; k++)
                angle = Bending.Hinge(0.01f, 0.3f, 0.1f, 5f, 0.5f, 1f, 0.004f, rate, angle, ref rate);
            Assert.That(angle.x, Is.EqualTo(0.1f).Within(1e-5f));
        }
    }
}
