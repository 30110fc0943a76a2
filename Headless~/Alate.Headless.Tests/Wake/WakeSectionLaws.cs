using System;
using System.Linq;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Laws of what the strips of a wing tell.</summary>
    public sealed class WakeSectionLaws
    {
        private static FreeWake Heaving(WakeMethod method) => new(
            new WakeSettings(method) { SpanPanels = 6, Stream = new float3(0f, 0f, -3f) },
            [new WakeWing(new ThinWing
            {
                Root = 0.3f,
                Span = 2.4f,
                Move = t => (0.3 * Math.Cos(2.0 * Math.PI * t), -0.6 * Math.PI * Math.Sin(2.0 * Math.PI * t), 0.1, 0.0),
            })]);

        [Test]
        public void AllStrips_HaveTheForceOfTheWing_AndItsInflowBetweenThem([Values] WakeMethod method)
        {
            using FreeWake wake = Heaving(method);
            for (int k = 0; k < 20; k++)
                wake.Step();
            WakeSection[] strips = [.. Enumerable.Range(0, wake.SectionCount).Select(strip => wake.Section(0, strip))];
            WakeLoads loads = wake.Loads(0);

            float3 sum = strips.Aggregate(float3.zero, (force, strip) => force + strip.Force);
            Assert.That(math.length(sum - loads.Force), Is.LessThan(1e-5f * math.length(loads.Force)));
            Assert.That(loads.Inflow.y, Is.InRange(strips.Min(strip => strip.Inflow.y), strips.Max(strip => strip.Inflow.y)));
            Assert.That(strips.Select(strip => strip.Span), Is.Ordered.Ascending.And.All.InRange(0f, 1f));
        }

        // Kelvin: what a wing had a step before lies in the newest row of its wake.
        [Test]
        public void TheNewestRings_HaveTheCirculationOfTheStepBefore([Values] WakeMethod method)
        {
            using FreeWake wake = Heaving(method);
            for (int k = 0; k < 10; k++)
                wake.Step();
            float[] before = [.. Enumerable.Range(0, wake.SectionCount).Select(strip => wake.Section(0, strip).Circulation)];
            wake.Step();

            for (int strip = 0; strip < before.Length; strip++)
                Assert.That(wake.Sheet(0).Circulation(0, strip), Is.EqualTo(before[strip]));
        }

        // Kutta and Joukowski; an ellipse has an elliptic circulation (Prandtl).
        [Test]
        public void AnEllipse_HasAnEllipticCirculation_AndTheForceOfItsStrips()
        {
            const float k_Span = 10f, k_Speed = 2f;
            var ellipse = new ThinWing
            {
                Root = -0.5f * k_Span,
                Span = k_Span,
                Chord = share => Math.Sqrt(Math.Max(1.0 - Math.Pow(2.0 * share - 1.0, 2), 1e-4)),
                Move = _ => (0.0, 0.0, 0.05, 0.0),
            };
            var settings = new WakeSettings
            {
                SpanPanels = 24,
                StepsPerBeat = 4,
                Keep = 30f,
                NearCore = 0.02f,
                FarCore = 0.02f,
                Stream = new float3(0f, 0f, -k_Speed),
            };
            using var wake = new FreeWake(
                settings, [new WakeWing(ellipse) { Coefficients = null, Downwash = MeasuredDownwash.None }]);
            for (int k = 0; k < 80; k++)
                wake.Step();

            float middle = 0.5f * (wake.Section(0, 11).Circulation + wake.Section(0, 12).Circulation), width = k_Span / 24f;
            for (int strip = 2; strip < 22; strip++)
            {
                WakeSection at = wake.Section(0, strip);
                double share = Math.Sqrt(1.0 - Math.Pow(2.0 * at.Span - 1.0, 2));
                Assert.That(at.Circulation / middle, Is.EqualTo(share).Within(0.025), $"at {at.Span}");
                // V × s points down in the axes of the body.
                Assert.That(at.Force.y, Is.EqualTo(-k_Speed * width * at.Circulation).Within(2).Percent);
            }
        }

        [TestCase(-1)]
        [TestCase(6)]
        public void AStripThatIsNot_IsRefused(int strip)
        {
            using FreeWake wake = Heaving(WakeMethod.Strips);
            wake.Step();
            Assert.That(() => wake.Section(0, strip), Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("6 strips"));
            Assert.That(() => wake.Section(1, 0), Throws.TypeOf<ArgumentOutOfRangeException>().With.Message.Contains("1 wings"));
        }
    }
}
