using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed class BendingTests
    {
        [Test]
        public void Hinge_TakesAStepOfBackwardEuler()
        {
            float4 rate = -1f;
            Bending.Hinge(0.01f, 0.2f, 0.05f, 5f, 0.3f, math.radians(30f), 0.004f, rate, 0.02f, ref rate);

            // ((I + c_a dt) ω + dt (τ - k θ)) / (I + (c + c_a) dt + k dt²)
            const double dt = 0.004,
                expected = ((0.01 + 0.05 * dt) * -1.0 + dt * (0.3 - 5.0 * 0.02)) / (0.01 + (0.2 + 0.05) * dt + 5.0 * dt * dt);
            Assert.That(rate.x, Is.EqualTo(expected).Within(-expected * Lanes.CheckTolerance));
        }

        [Test]
        public void Hinge_StopsAtItsLimit_AndDropsTheOutwardRate()
        {
            float4 rate = 10f;
            float4 angle = Bending.Hinge(0.01f, 0.2f, 0f, 5f, 30f, math.radians(30f), 0.02f, rate, 0.5f, ref rate);
            Assert.That(angle.x, Is.EqualTo(Math.PI / 6.0).Within(Math.PI / 6.0 * Lanes.CheckTolerance));
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
