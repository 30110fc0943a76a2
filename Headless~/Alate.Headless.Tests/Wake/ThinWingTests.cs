using System;
using System.Collections.Generic;
using System.Numerics;
using Alate.Wake;
using MathNet.Numerics;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests.Wake
{
    /// <summary>Panels against the theories of thin wings in attached flow.</summary>
    public sealed class ThinWingTests
    {
        private const double k_Degree = Math.PI / 180.0;

        // Lift and thrust of a strip of unit width over the density, of a plate in two dimensions that has beaten for some time.
        private static (Complex Lift, double Thrust) Oscillate(double reduced, Func<double, (double, double, double, double)> move)
        {
            // Semichord 1/2, so that k = ω/2U; one beat is the period.
            const int k_Steps = 64, k_Beats = 6;
            var plate = new Plate { Span = 10000f, Root = -5000f, Pivot = 0.25, Move = move };
            var settings = new WakeSettings(WakeMethod.Panels)
            {
                ChordPanels = 8,
                SpanPanels = 1,
                StepsPerBeat = k_Steps,
                Keep = k_Beats,
                Stream = new float3(0f, 0f, (float)(-Math.PI / reduced)),
                NearCore = 0.02f,
                FarCore = 0.02f,
                SuctionAlongChord = true,
            };
            using var wake = new FreeWake(settings, new[] { new WakeWing(plate) });
            Complex lift = 0.0;
            double thrust = 0.0;
            for (int k = 0; k < k_Beats * k_Steps; k++)
            {
                double time = wake.Time;
                wake.Step();
                float3 force = wake.Loads(0).Force;
                if (k < (k_Beats - 1) * k_Steps)
                    continue;
                lift += 2.0 * force.y * Complex.Exp(-2.0 * Math.PI * Complex.ImaginaryOne * time) / k_Steps;
                thrust += force.z / (double)k_Steps;
            }

            // One panel, a quarter of it short at both ends.
            const double k_Width = 10000.0 / 1.5;
            return (lift / k_Width, thrust / k_Width);
        }

        // Theodorsen's function by Hankel functions.
        private static Complex Lag(double k) =>
            SpecialFunctions.HankelH2(1, k) / (SpecialFunctions.HankelH2(1, k) + Complex.ImaginaryOne * SpecialFunctions.HankelH2(0, k));

        private static void AssertNear(Complex ours, Complex theory, double amplitude, double degrees)
        {
            Complex ratio = ours / theory;
            Assert.That(ratio.Magnitude, Is.EqualTo(1.0).Within(amplitude));
            Assert.That(ratio.Phase / k_Degree, Is.EqualTo(0.0).Within(degrees));
        }

        [TestCase(0.1, 0.01, 0.5, Explicit = true, Category = "Long")]
        [TestCase(0.3, 0.015, 2.0)]
        [TestCase(0.5, 0.05, 2.6, Explicit = true, Category = "Long")]
        public void LiftOfAHeavingPlate_IsTheodorsens(double reduced, double amplitude, double degrees)
        {
            const double k_Height = 0.01, k_Rate = 2.0 * Math.PI;
            (Complex lift, double thrust) = Oscillate(
                reduced, t => (k_Height * Math.Cos(k_Rate * t), -k_Height * k_Rate * Math.Sin(k_Rate * t), 0.0, 0.0));
            double speed = Math.PI / reduced, b = 0.5;
            // Theodorsen counts the height downwards.
            Complex lag = Lag(reduced), down = -k_Height, i = Complex.ImaginaryOne;
            Complex theory = -Math.PI * b * b * k_Rate * k_Rate * down + 2.0 * Math.PI * speed * b * lag * i * k_Rate * down;
            AssertNear(lift, theory, amplitude, degrees);

            // Garrick 1936: the mean thrust of a heaving plate is all suction, πρb ω² h² |C|² a unit of width.
            double garrick = Math.PI * b * k_Rate * k_Rate * k_Height * k_Height * lag.Magnitude * lag.Magnitude;
            Assert.That(thrust / garrick, Is.EqualTo(1.0).Within(0.025));
        }

        [TestCase(0.1, 0.01, 0.5, Explicit = true, Category = "Long")]
        [TestCase(0.3, 0.015, 2.0)]
        [TestCase(0.5, 0.045, 2.6, Explicit = true, Category = "Long")]
        public void LiftOfAPlatePitchedAboutAQuarter_IsTheodorsens(double reduced, double amplitude, double degrees)
        {
            const double k_Pitch = k_Degree, k_Rate = 2.0 * Math.PI;
            (Complex lift, _) = Oscillate(
                reduced, t => (0.0, 0.0, k_Pitch * Math.Cos(k_Rate * t), -k_Pitch * k_Rate * Math.Sin(k_Rate * t)));
            double speed = Math.PI / reduced, b = 0.5, axis = -0.5;
            Complex i = Complex.ImaginaryOne, pitch = k_Pitch;
            Complex carried = Math.PI * b * b * (speed * i * k_Rate + b * axis * k_Rate * k_Rate) * pitch;
            Complex circulatory = 2.0 * Math.PI * speed * b * Lag(reduced) * (speed + b * (0.5 - axis) * i * k_Rate) * pitch;
            AssertNear(lift, carried + circulatory, amplitude, degrees);
        }

        [Test]
        public void LiftAfterASuddenStart_GrowsAsWagners()
        {
            const int k_Steps = 16;
            using var wake = new FreeWake(
                new WakeSettings(WakeMethod.Panels)
                {
                    ChordPanels = 8,
                    SpanPanels = 1,
                    StepsPerBeat = k_Steps,
                    Keep = 10f,
                    Stream = new float3(0f, 0f, -1f),
                    NearCore = 0.02f,
                    FarCore = 0.02f,
                    TurnedSuction = 0f,
                },
                new[] { new WakeWing(Plate.Steady(10000f, 5.0 * k_Degree)) });
            // Semichords travelled, and the largest error, which falls as the wake behind the edge gets longer than a panel.
            var errors = new Dictionary<double, double> { [1] = 0.08, [2] = 0.05, [4] = 0.025, [8] = 0.01, [16] = 0.01 };
            for (int k = 0; k <= 8 * k_Steps; k++)
            {
                wake.Step();
                double travelled = 2.0 * k / k_Steps;
                if (!errors.TryGetValue(travelled, out double error))
                    continue;
                // R. T. Jones 1940.
                double growth = 1.0 - 0.165 * Math.Exp(-0.0455 * travelled) - 0.335 * Math.Exp(-0.3 * travelled);
                double normal = wake.Loads(0).Force.y / Math.Cos(5.0 * k_Degree) / (0.5 * 10000.0 / 1.5);
                Assert.That(normal / (2.0 * Math.PI * Math.Sin(5.0 * k_Degree) * growth), Is.EqualTo(1.0).Within(error), $"{travelled}");
            }
        }

        // Lift over the angle, of a coefficient on the whole area.
        private static double Slope(Plate plate, double area, int across, int along, Func<WakeSettings, WakeSettings> change = null)
        {
            var settings = new WakeSettings(WakeMethod.Panels)
            {
                ChordPanels = across,
                SpanPanels = along,
                StepsPerBeat = 4,
                Keep = 20f,
                Stream = new float3(0f, 0f, -1f),
                NearCore = 0.02f,
                FarCore = 0.02f,
                SuctionAlongChord = true,
            };
            using var wake = new FreeWake(change?.Invoke(settings) ?? settings, new[] { new WakeWing(plate) });
            for (int k = 0; k < 60; k++)
                wake.Step();
            return wake.Loads(0).Force.y / (0.5 * area * 2.0 * k_Degree);
        }

        // Rectangles: limits of ever finer lattices, which lattices of 4 × 10, 8 × 20 and 16 × 40 panels approach from below.
        [TestCase(1f, 1.460)]
        [TestCase(2f, 2.474)]
        public void SlopeOfARectangle_IsThatOfLiftingSurfaceTheory(float ratio, double theory) =>
            Assert.That(Slope(Plate.Steady(ratio, 2.0 * k_Degree), ratio, 6, 14), Is.EqualTo(theory).Within(0.005 * theory));

        [Test]
        public void SlopeOfACircle_IsThatOfLiftingSurfaceTheory()
        {
            var circle = new Plate
            {
                Span = 1f,
                Root = -0.5f,
                Pivot = 0.5,
                Chord = Round,
                Move = _ => (0.0, 0.0, 2.0 * k_Degree, 0.0),
            };
            Assert.That(Slope(circle, Math.PI / 4.0, 6, 14), Is.EqualTo(1.790).Within(0.02));
        }

        [Test]
        public void SlopeOfASlenderEllipse_IsThatOfLiftingLine()
        {
            float span = 10f * math.PI / 4f;
            var ellipse = new Plate
            {
                Span = span,
                Root = -0.5f * span,
                Pivot = 0.5,
                Chord = Round,
                Move = _ => (0.0, 0.0, 2.0 * k_Degree, 0.0),
            };
            // Helmbold's, for a wing of an aspect ratio of 10: lifting line alone has 2 % more.
            double helmbold = 2.0 * Math.PI * 10.0 / (2.0 + Math.Sqrt(100.0 + 4.0));
            Assert.That(Slope(ellipse, 0.25 * Math.PI * span, 4, 20), Is.EqualTo(helmbold).Within(0.03 * helmbold));
        }

        [Test]
        public void AGroundBelow_RaisesTheLift()
        {
            var plate = Plate.Steady(4f, 2.0 * k_Degree);
            double free = Slope(plate, 4.0, 3, 8);
            double high = Slope(plate, 4.0, 3, 8, settings =>
            {
                settings.GroundHeight = 2f;
                return settings;
            });
            double low = Slope(plate, 4.0, 3, 8, settings =>
            {
                settings.GroundHeight = 0.5f;
                return settings;
            });
            Assert.That(high, Is.GreaterThan(1.01 * free));
            Assert.That(low, Is.GreaterThan(1.05 * high));
        }

        [TestCase(1, 0.5 * Math.PI)]
        [TestCase(256, 1.7724538509)]
        public void FactorOfTheLeadingEdge_GoesFromHalfPiToItsRoot(int panels, double factor) =>
            Assert.That(LeadingEdge.Factor(panels), Is.EqualTo(factor).Within(panels == 1 ? 1e-6 : 2e-3));

        private static double Round(float share) => Math.Sqrt(Math.Max(0.0, 1.0 - (2.0 * share - 1.0) * (2.0 * share - 1.0)));
    }
}
