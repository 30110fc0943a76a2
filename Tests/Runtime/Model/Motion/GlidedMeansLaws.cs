using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Middle and tilt of the stroke, as commanded, which glide over the first half of the beat, and their rates.</summary>
    public sealed unsafe class GlidedMeansLaws
    {
        private PackFixture m_Fixture;

        [SetUp]
        public void SetUp() => m_Fixture = new PackFixture(Monarch.Rig(), WingParameters.Default);

        [TearDown]
        public void TearDown() => m_Fixture.Dispose();

        [TestCase(0f)]
        [TestCase(0.4f)]
        [TestCase(1.5f)]
        [TestCase(2.9f)]
        [TestCase(4f)]
        public void EachMean_IsOnItsSmoothWay_WithTheSlopesOfIt(float phase)
        {
            ref BeatState beat = ref *m_Fixture.Pack.beat;
            beat.phase = phase;
            float3 now = new float3(0.1f, -0.2f, 0.3f), before = new float3(-0.3f, 0.25f, 0.05f);
            beat.means = Lanes.All(now.x, now.y, now.z);
            beat.means1 = Lanes.All(before.x, before.y, before.z);
            beat.meanFlap = 0.2f;
            beat.meanFlap1 = -0.35f;
            m_Fixture.Pack.parameters->tilt = 0.15f;
            m_Fixture.Pack.parameters->numbers.meanFlap = 0.4f;
            GlidedMeans.Evaluate(m_Fixture.Pack, m_Fixture.scratch);
            StrokeMeans means = *m_Fixture.scratch.means;

            double x = Math.Min(phase / Math.PI, 1.0), share = x * x * (3.0 - 2.0 * x), slope = 6.0 * x * (1.0 - x) / Math.PI;
            double bend = x > 0.0 && x < 1.0 ? (6.0 - 12.0 * x) / (Math.PI * Math.PI) : 0.0;
            double turn = -(0.15 - 0.3 + 0.4 * share);
            Near(means.tiltSin, Math.Sin(turn));
            Near(means.tiltCos, Math.Cos(turn));
            Near(means.tiltHalfSin, Math.Sin(0.5 * turn));
            Near(means.tiltHalfCos, Math.Cos(0.5 * turn));
            Near(means.tiltRate, -0.4 * slope);
            Near(means.tiltCurvature, -0.4 * bend);
            Near(means.angle.x, 0.4 - 0.35 + 0.55 * share);
            Near(means.rate.x, 0.55 * slope);
            Near(means.curvature.x, 0.55 * bend);
            Near(means.angle.y, 0.25 - 0.45 * share);
            Near(means.rate.y, -0.45 * slope);
            Near(means.curvature.y, -0.45 * bend);
            Near(means.angle.z, 0.05 + 0.25 * share);
            Near(means.rate.z, 0.25 * slope);
            Near(means.curvature.z, 0.25 * bend);
        }

        private static void Near(float4 lanes, double expected)
        {
            for (int lane = 0; lane < WingPack.Lanes; lane++)
                Assert.That(lanes[lane], Is.EqualTo(expected).Within(1e-5));
        }
    }
}
