using System;
using System.Numerics;
using Alate.Cli;
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

        // Far behind an elliptic line the air beside its wake rises by the largest circulation over the span, times y/√(y² − ¼) − 1.
        [TestCase(1.1)]
        [TestCase(1.5)]
        [TestCase(3.0)]
        public void FarBehindAnEllipse_TheSecondIsLiftedByTheAirBesideItsWake(double aside)
        {
            const double ratio = 8;
            double middle = 2 * 2 * Math.PI / (1 + 2 / ratio) / (Math.PI * ratio);
            double gain = Integrate.OnClosedInterval(
                at => Math.Sin(at) * Math.Sin(at) * middle * (1 / Math.Sqrt(1 - 0.25 / Math.Pow(aside + 0.5 * Math.Cos(at), 2)) - 1),
                0, Math.PI);
            Assert.That(ThinWingTheory.Following(ratio, aside, 1000) - 1, Is.EqualTo(gain / (0.5 * Math.PI)).Within(0.1).Percent);
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
            (Complex lift, double thrust) = ThinWing.Oscillate(
                reduced, 8, 64, t => (k_Height * Math.Cos(k_Rate * t), -k_Height * k_Rate * Math.Sin(k_Rate * t), 0.0, 0.0));
            double speed = Math.PI / reduced, b = 0.5;
            // Theodorsen counts the height downwards.
            Complex lag = Lag(reduced), down = -k_Height, i = Complex.ImaginaryOne;
            Complex theory = -Math.PI * b * b * k_Rate * k_Rate * down + 2.0 * Math.PI * speed * b * lag * i * k_Rate * down;
            AssertNear(lift, theory, amplitude, degrees);
            AssertNear(ThinWingTheory.Heaving(reduced, k_Height), theory, 1e-4, 0.01);

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
            (Complex lift, _) = ThinWing.Oscillate(
                reduced, 8, 64, t => (0.0, 0.0, k_Pitch * Math.Cos(k_Rate * t), -k_Pitch * k_Rate * Math.Sin(k_Rate * t)));
            double speed = Math.PI / reduced, b = 0.5, axis = -0.5;
            Complex i = Complex.ImaginaryOne, pitch = k_Pitch;
            Complex carried = Math.PI * b * b * (speed * i * k_Rate + b * axis * k_Rate * k_Rate) * pitch;
            Complex circulatory = 2.0 * Math.PI * speed * b * Lag(reduced) * (speed + b * (0.5 - axis) * i * k_Rate) * pitch;
            AssertNear(lift, carried + circulatory, amplitude, degrees);
            AssertNear(ThinWingTheory.Pitching(reduced, k_Pitch), carried + circulatory, 1e-4, 0.01);
        }

        [Test]
        public void LiftAfterASuddenStart_GrowsAsWagners()
        {
            // Semichords travelled, and the largest error, which falls as the wake behind the edge gets longer than a panel.
            foreach ((double travelled, double error) in new[] { (1.0, 0.08), (2, 0.05), (4, 0.025), (8, 0.01), (16, 0.01) })
            {
                // R. T. Jones 1940.
                double growth = 1.0 - 0.165 * Math.Exp(-0.0455 * travelled) - 0.335 * Math.Exp(-0.3 * travelled);
                Assert.That(ThinWing.Started(travelled, 8, 16) / (2.0 * Math.PI * Math.Sin(5.0 * k_Degree) * growth),
                    Is.EqualTo(1.0).Within(error), $"{travelled}");
                Assert.That(ThinWingTheory.Wagner(travelled),
                    Is.EqualTo(2.0 * Math.PI * Math.Sin(5.0 * k_Degree) * growth).Within(1e-12));
            }
        }

        // Rectangles: limits of ever finer lattices, which lattices of 4 × 10, 8 × 20 and 16 × 40 panels approach from below.
        [TestCase(1f, 1.460)]
        [TestCase(2f, 2.474)]
        public void SlopeOfARectangle_IsThatOfLiftingSurfaceTheory(float ratio, double theory) =>
            Assert.That(ThinWing.Slope(ThinWing.Rectangle(ratio), ratio, 6, 14).Slope, Is.EqualTo(theory).Within(0.005 * theory));

        [Test]
        public void SlopeOfACircle_IsThatOfLiftingSurfaceTheory() =>
            Assert.That(ThinWing.Slope(ThinWing.Ellipse(1f), Math.PI / 4.0, 6, 14).Slope, Is.EqualTo(1.790).Within(0.02));

        [Test]
        public void SlopeOfASlenderEllipse_IsThatOfLiftingLine()
        {
            float span = 10f * math.PI / 4f;
            // Helmbold's, for a wing of an aspect ratio of 10: lifting line alone has 2 % more.
            double helmbold = 2.0 * Math.PI * 10.0 / (2.0 + Math.Sqrt(100.0 + 4.0));
            Assert.That(ThinWing.Slope(ThinWing.Ellipse(span), 0.25 * Math.PI * span, 4, 20).Slope,
                Is.EqualTo(helmbold).Within(0.03 * helmbold));
            Assert.That(ThinWingTheory.Helmbold(10.0), Is.EqualTo(helmbold).Within(1e-9));
        }

        [Test]
        public void AGroundBelow_RaisesTheLift()
        {
            double Slope(float? ground = null) => ThinWing.Slope(ThinWing.Rectangle(4f), 4.0, 3, 8, ground).Slope;
            double free = Slope(), high = Slope(2f), low = Slope(0.5f);
            Assert.That(high, Is.GreaterThan(1.01 * free));
            Assert.That(low, Is.GreaterThan(1.05 * high));
        }

        // The report's closed forms have Bessel functions by their integrals; these are a library's.
        [TestCase(0.05)]
        [TestCase(0.1)]
        [TestCase(0.5)]
        [TestCase(2.0)]
        public void TheReportsFunctionOfTheodorsen_IsThatOfHankelFunctions(double reduced)
        {
            Complex lag = Lag(reduced);
            Assert.That((ThinWingTheory.Theodorsen(reduced) - lag).Magnitude, Is.LessThan(1e-4));
            // Garrick's for unit speeds and a semichord of a half: πρb (ωh)² |C|².
            Assert.That(ThinWingTheory.Garrick(reduced, 0.01),
                Is.EqualTo(0.5 * Math.PI * Math.Pow(2.0 * Math.PI * 0.01 * lag.Magnitude, 2)).Within(0.1).Percent);
        }

        [TestCase(1, 0.5 * Math.PI)]
        [TestCase(256, 1.7724538509)]
        public void FactorOfTheLeadingEdge_GoesFromHalfPiToItsRoot(int panels, double factor) =>
            Assert.That(LeadingEdge.Factor(panels), Is.EqualTo(factor).Within(panels == 1 ? 1e-6 : 2e-3));
    }
}
