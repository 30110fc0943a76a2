using System;
using Alate.Cli;
using Alate.Wake;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Strips that shed a free wake, against the measurement of their coefficients and the theory of lifting lines.</summary>
    public sealed class StripTests
    {
        [Test]
        public void TheWingOfTheMeasurement_GetsItsCoefficientsBack([Values(10, 20, 30, 40, 50, 60, 70, 80)] int degrees)
        {
            (double lift, double drag) = RevolvingWing.Fly(degrees, new WakeSettings { Keep = 4f }, MeasuredDownwash.RevolvingWing);
            Assert.That(lift / RevolvingWing.MeasuredLift(degrees), Is.EqualTo(1.0).Within(0.03));
            Assert.That(drag / RevolvingWing.MeasuredDrag(degrees), Is.EqualTo(1.0).Within(0.03));
        }

        [Test]
        public void PanelsWithHalfOfTheSuction_LieNearTheMeasurement([Values(10, 20, 30, 40, 50)] int degrees)
        {
            (double lift, double drag) = RevolvingWing.Fly(degrees, new WakeSettings(WakeMethod.Panels) { Keep = 4f });
            Assert.That(lift / RevolvingWing.MeasuredLift(degrees), Is.EqualTo(1.0).Within(0.12));
            // No friction: the drag at small angles is missing.
            if (degrees >= 30)
                Assert.That(drag / RevolvingWing.MeasuredDrag(degrees), Is.EqualTo(1.0).Within(0.12));
        }

        [Test]
        public void SectionsOfAThinPlate_MakeALiftingLine()
        {
            const double k_Pitch = 0.05;
            float span = 8f;
            var settings = new WakeSettings
            {
                SpanPanels = 20,
                StepsPerBeat = 4,
                Keep = 30f,
                NearCore = 0.02f,
                FarCore = 0.02f,
                Stream = new float3(0f, 0f, -1f),
            };
            using var wake = new FreeWake(
                settings, new[] { new WakeWing(ThinWing.Steady(span, k_Pitch)) { Coefficients = null, Downwash = MeasuredDownwash.None } });
            for (int k = 0; k < 100; k++)
                wake.Step();
            Assert.That(wake.Failures, Is.Zero);
            // Lifting line of a rectangle of this ratio: 2π/(1 + 2 (1 + τ)/8), τ = 0.19 by Glauert's series.
            double theory = 2.0 * Math.PI / (1.0 + 2.0 * 1.19 / 8.0);
            Assert.That(wake.Loads(0).Force.y / (0.5 * span * k_Pitch), Is.EqualTo(theory).Within(0.03 * theory));
            // The lift leans back by the mean downwash: C_D = C_L²/(π A e), e of a rectangle about 0.95.
            double lift = wake.Loads(0).Force.y / (0.5 * span), drag = -wake.Loads(0).Force.z / (0.5 * span);
            Assert.That(lift * lift / (Math.PI * span * drag), Is.EqualTo(0.95).Within(0.05));
        }

        [Test]
        public void WithoutAWake_AStripHasItsCoefficients()
        {
            var polar = new StripPolar(CoefficientSet.Dickinson1999, MeasuredDownwash.None);
            foreach (double degrees in new[] { 5.0, 30.0, 62.5, 90.0 })
            {
                polar.Evaluate((float)(degrees * Math.PI / 180.0), out float lift, out float drag, out float outer);
                Assert.That(lift, Is.EqualTo(RevolvingWing.MeasuredLift(degrees)).Within(2e-3));
                Assert.That(drag, Is.EqualTo(RevolvingWing.MeasuredDrag(degrees)).Within(2e-3));
                Assert.That(outer, Is.EqualTo(degrees * Math.PI / 180.0).Within(1e-5));
            }
        }

        [Test]
        public void AWingAndItsMirrorImage_AreTwoWings()
        {
            ThinWing right = Beating(0.2f, 1f), left = Beating(-0.2f, -1f);
            var both = new WakeSettings { SpanPanels = 6, Stream = new float3(0f, 0f, -2f) };
            var half = new WakeSettings { SpanPanels = 6, Stream = new float3(0f, 0f, -2f), Symmetric = true };
            using var two = new FreeWake(both, new[] { new WakeWing(right), new WakeWing(left) });
            using var one = new FreeWake(half, new[] { new WakeWing(right) });
            for (int k = 0; k < 48; k++)
            {
                two.Step();
                one.Step();
                float3 force = one.Loads(0).Force, mirrored = two.Loads(1).Force * new float3(-1f, 1f, 1f);
                float size = math.length(force) + 0.1f;
                Assert.That(math.length(two.Loads(0).Force - force) / size, Is.LessThan(2e-3f));
                Assert.That(math.length(two.Loads(1).Force - mirrored) / size, Is.LessThan(1f), "mirrored wing");
            }
        }

        private static ThinWing Beating(float root, float side) => new()
        {
            Root = root,
            Span = 2f * side,
            Move = t => (0.3 * Math.Cos(2.0 * Math.PI * t), -0.6 * Math.PI * Math.Sin(2.0 * Math.PI * t), 0.2, 0.0),
        };
    }
}
