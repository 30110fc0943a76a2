using System;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Laws of what a step tells: power, moment and inflow, and of the cores of vortices.</summary>
    public sealed class WakeLoadLaws
    {
        private static double Rise(double beats) => -0.6 * Math.PI * Math.Sin(2.0 * Math.PI * beats);

        private static ThinWing Heaving(float root, float span) => new()
        {
            Root = root,
            Span = span,
            Move = t => (0.3 * Math.Cos(2.0 * Math.PI * t), Rise(t), 0.1, 0.0),
        };

        [Test]
        public void AStiffWingThatHeaves_WorksAgainstItsLift([Values] WakeMethod method)
        {
            using var wake = new FreeWake(
                new WakeSettings(method) { SpanPanels = 6, Stream = new float3(0f, 0f, -3f) }, new[] { new WakeWing(Heaving(-1.5f, 3f)) });
            for (int k = 0; k < 30; k++)
            {
                double time = wake.Time;
                wake.Step();
                WakeLoads loads = wake.Loads(0);
                Assert.That(loads.Power, Is.EqualTo(-loads.Force.y * Rise(time)).Within(1e-3 * math.length(loads.Force) + 1e-5));
            }
        }

        [Test]
        public void TheMoment_IsThatOfTheForceAtItsPlace_AboutTheOrigin()
        {
            // One strip from 1 to 3: its force acts in the middle, at half of the chord.
            using var wake = new FreeWake(
                new WakeSettings { SpanPanels = 1, Stream = new float3(0f, 0f, -3f) }, new[] { new WakeWing(Heaving(1f, 2f)) });
            for (int k = 0; k < 10; k++)
            {
                double time = wake.Time;
                wake.Step();
                var at = new float3(
                    2f, (float)(0.3 * Math.Cos(2.0 * Math.PI * time) - 0.5 * Math.Sin(0.1)), (float)(-0.5 * Math.Cos(0.1)));
                float3 moment = math.cross(at, wake.Loads(0).Force);
                Assert.That(math.length(wake.Loads(0).Moment - moment), Is.LessThan(1e-3f * math.length(moment) + 1e-5f));
            }
        }

        [Test]
        public void TheInflowOfASteadyWing_IsTheDownwashOfItsLift_AndNoneIsLeftOfTheMeasuredOne()
        {
            const float k_Span = 8f;
            float3 Inflow(MeasuredDownwash downwash, out float lift)
            {
                using var wake = new FreeWake(
                    new WakeSettings { SpanPanels = 16, StepsPerBeat = 4, Keep = 25f, Stream = new float3(0f, 0f, -1f) },
                    new[] { new WakeWing(ThinWing.Steady(k_Span, 0.3)) { Downwash = downwash } });
                for (int k = 0; k < 80; k++)
                    wake.Step();
                lift = wake.Loads(0).Force.y / (0.5f * k_Span);
                return wake.Loads(0).Inflow;
            }

            float3 whole = Inflow(MeasuredDownwash.None, out float alone), rest = Inflow(MeasuredDownwash.Angle, out float more);
            // Lifting line: C_L / (π A) of an elliptic wing; a rectangle's mean is about a fifth more.
            Assert.That(whole.y, Is.EqualTo(-1.1f * alone / (math.PI * k_Span)).Within(0.2f * alone / (math.PI * k_Span)));
            Assert.That(rest.y, Is.GreaterThan(whole.y + 0.5f * 0.15f * more));
        }

        [Test]
        public void Cores_WidenFromTheShedOne_WithinTheRamp_AndByViscosity()
        {
            var settings = new WakeSettings { NearCore = 0.1f, FarCore = 0.5f, CoreRamp = 0.4f, BoundCore = 0.2f };
            var cores = new WakeCores(settings, 2f);
            Assert.That(cores.Bound, Is.EqualTo(0.4f * 0.4f).Within(1e-6f));
            Assert.That(cores.Shed, Is.EqualTo(0.2f * 0.2f).Within(1e-6f));
            Assert.That(cores.Of(0f, 3f), Is.EqualTo(cores.Shed));
            Assert.That(cores.Of(0.2f, 0f), Is.EqualTo(0.6f * 0.6f).Within(1e-6f));
            Assert.That(cores.Of(0.4f, 0f), Is.EqualTo(1f).Within(1e-6f));
            Assert.That(cores.Of(7f, 0f), Is.EqualTo(1f).Within(1e-6f));

            // Lamb and Oseen: r² = 4 · 1.25643 ν t; the turbulent part is 1e-4 of the circulation.
            settings.Viscosity = 0.01f;
            Assert.That(new WakeCores(settings, 2f).Of(7f, 20f), Is.EqualTo(1f + 4f * 1.25643f * (0.01f + 0.002f) * 7f).Within(1e-5f));
        }
    }
}
