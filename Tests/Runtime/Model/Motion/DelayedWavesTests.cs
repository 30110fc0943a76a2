using System;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    public sealed unsafe class DelayedWavesTests
    {
        private PackFixture m_Fixture;

        [SetUp]
        public void SetUp()
        {
            WingParameters parameters = WingParameters.Default;
            parameters.rootShare = 1f;
            parameters.meanFlap = 0f;
            parameters.options.coupling = MembraneCoupling.OneWay;
            m_Fixture = new PackFixture(Monarch.Rig(), parameters);
        }

        [TearDown]
        public void TearDown() => m_Fixture.Dispose();

        [Test]
        public void Amplitude_GlidesOverTheFirstHalfOfItsCycle()
        {
            Set(20f, 55f, 55f, phase: 2.5f, delay: 0f);
            Evaluate();
            double expected = 55.0 + (20.0 - 55.0) * Smooth(2.5 / Math.PI);
            Assert.That(math.degrees(m_Fixture.scratch.amplitude[0].x.x), Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void Flap_WithADelayWithinTheCycle_HasTheSlopeOfItsWave()
        {
            Set(60f, 30f, 45f, phase: 1f, delay: 0.3f);
            Evaluate();

            // d/dp of A(p) cos p at p = 1 - 0.3.
            double p = 0.7, x = p / Math.PI, amplitude = 30.0 + (60.0 - 30.0) * Smooth(x),
                glide = (60.0 - 30.0) * 6.0 * x * (1.0 - x) / Math.PI;
            double expected = (glide * Math.Cos(p) - amplitude * Math.Sin(p)) * Math.PI / 180.0;
            Assert.That(m_Fixture.scratch.angleRate[0].x.x, Is.EqualTo(expected).Within(-expected * Lanes.CheckTolerance));
        }

        [Test]
        public void Flap_WithADelayIntoTheLastCycle_HasTheAngleOfThatCycle()
        {
            Set(60f, 30f, 45f, phase: 1f, delay: 1.5f);
            Evaluate();

            // Late in the last cycle, whose amplitude of 30° has been reached.
            double expected = Math.PI / 6.0 * Math.Cos(1.0 - 1.5 + 2.0 * Math.PI);
            Assert.That(m_Fixture.scratch.angle[0].x.x, Is.EqualTo(expected).Within(expected * Lanes.CheckTolerance));
        }

        [Test]
        public void Delay_OfAChain_IsThatOfEquation2()
        {
            m_Fixture.Pack.parameters->chordDelay = math.PI;
            m_Fixture.Pack.parameters->spanDelay = 0f;
            m_Fixture.Pack.rig.chainRatio[3] = 0.75f;
            Set(60f, 60f, 60f, phase: 3f, delay: 0f, keepDelay: true);
            Evaluate();
            int bone = 3 * (m_Fixture.rig.JointsPerChain - 1);
            Assert.That(
                3f - m_Fixture.scratch.localPhase[bone].x, Is.EqualTo(0.75 * Math.PI).Within(0.75 * Math.PI * Lanes.CheckTolerance));
        }

        [Test]
        public void TrailingChain_WaitsAtTheTop_UntilItsDelayHasPassed()
        {
            m_Fixture.Pack.parameters->chordDelay = math.PI;
            m_Fixture.Pack.parameters->spanDelay = 0f;
            m_Fixture.Pack.beat->cycles = 0f;
            int last = (m_Fixture.rig.ChainCount - 1) * (m_Fixture.rig.JointsPerChain - 1);
            float top = m_Fixture.Pack.beat->amplitude.x.x;

            m_Fixture.Pack.beat->phase = 3f;
            Evaluate();
            Assert.That(m_Fixture.scratch.angle[last].x.x, Is.EqualTo(top).Within(1e-6));
            Assert.That(m_Fixture.scratch.angleRate[last].x.x, Is.Zero);
            Assert.That(m_Fixture.scratch.angleCurvature[last].x.x, Is.Zero);

            m_Fixture.Pack.beat->phase = math.PI + 0.5f;
            Evaluate();
            Assert.That(m_Fixture.scratch.angle[last].x.x, Is.LessThan(top));
        }

        [Test]
        public void Derivatives_AreThoseOfTheAngle()
        {
            const float h = 1e-3f;
            for (float phase = 0.3f; phase < 6f; phase += 0.37f)
            {
                Set(60f, 30f, 45f, phase - h, delay: 0.2f);
                Evaluate();
                float3 before = m_Fixture.scratch.angle[0][0], slopeBefore = m_Fixture.scratch.angleRate[0][0];
                Set(60f, 30f, 45f, phase + h, delay: 0.2f);
                Evaluate();
                float3 after = m_Fixture.scratch.angle[0][0], slopeAfter = m_Fixture.scratch.angleRate[0][0];
                Set(60f, 30f, 45f, phase, delay: 0.2f);
                Evaluate();
                float3 slope = (after - before) / (2f * h), curvature = (slopeAfter - slopeBefore) / (2f * h);
                Assert.That(math.length(m_Fixture.scratch.angleRate[0][0] - slope), Is.LessThan(2e-3f), $"rate at {phase}");
                Assert.That(math.length(m_Fixture.scratch.angleCurvature[0][0] - curvature), Is.LessThan(2e-3f), $"curvature at {phase}");
            }
        }

        private static double Smooth(double x) => x * x * (3.0 - 2.0 * x);

        private void Set(float now, float before, float earlier, float phase, float delay, bool keepDelay = false)
        {
            ref BeatState beat = ref *m_Fixture.Pack.beat;
            beat.phase = phase;
            beat.cycles = 3f;
            beat.amplitude = Lanes.All(math.radians(now), 0f, 0f);
            beat.amplitude1 = Lanes.All(math.radians(before), 0f, 0f);
            beat.amplitude2 = Lanes.All(math.radians(earlier), 0f, 0f);
            beat.amplitude3 = Lanes.All(math.radians(earlier), 0f, 0f);
            m_Fixture.Pack.parameters->wingDelay = delay;
            if (!keepDelay)
                m_Fixture.Pack.parameters->chordDelay = m_Fixture.Pack.parameters->spanDelay = 0f;
        }

        private void Evaluate()
        {
            ChainDelays.Derive(m_Fixture.Pack);
            DelayedWaves.Evaluate(m_Fixture.Pack, m_Fixture.scratch);
        }
    }
}
