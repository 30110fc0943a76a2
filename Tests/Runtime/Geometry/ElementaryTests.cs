using System;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;

namespace Alate.Tests
{
    /// <summary>Sines, powers and logarithms of our own against the system's, on dense and random arguments.</summary>
    public sealed class ElementaryTests
    {
        private const int k_Dense = 20000;

        [TestCase(-0.8, 0.8)]
        [TestCase(-10.0, 10.0)]
        [TestCase(-1e6, 1e6)]
        public void SineAndCosine_AreWithinTwoUnitsOfTheLastPlace(double from, double to)
        {
            Assert.That(Worst(Elementary.Sin, Math.Sin, from, to), Is.LessThanOrEqualTo(2.0));
            Assert.That(Worst(Elementary.Cos, Math.Cos, from, to), Is.LessThanOrEqualTo(2.0));
        }

        [Test]
        public void Tangents_AndTheirInverses_AreWithinThreeUnits()
        {
            Assert.That(Worst(Elementary.Tan, Math.Tan, -10.0, 10.0), Is.LessThanOrEqualTo(3.0));
            Assert.That(
                Worst(a => Elementary.Atan2(Math.Sin(a), Math.Cos(a)), a => Math.Atan2(Math.Sin(a), Math.Cos(a)), -3.2, 3.2),
                Is.LessThanOrEqualTo(2.0));
            Assert.That(Worst(Elementary.Asin, Math.Asin, -1.0, 1.0), Is.LessThanOrEqualTo(3.0));
            Assert.That(Worst(Elementary.Acos, Math.Acos, -1.0, 1.0), Is.LessThanOrEqualTo(3.0));
            Assert.That(Worst(Elementary.Acos, Math.Acos, 0.9999, 1.0), Is.LessThanOrEqualTo(3.0));
        }

        // Beyond 87 a float overflows at 88.7 and has fewer digits from −87.3 on, down to none.
        [Test]
        public void TheExponentialOfAFloat_IsThatOfADouble_AtItsEnds()
        {
            foreach (float power in new[]
            {
                87f, 87.5f, 88.7f, 88.8f, 95f, 1000f, -87f, -87.5f, -90f, -95f, -95.6f, -96f, -100f, -103f, -104f,
            })
            {
                Assert.That(Elementary.Exp(power), Is.EqualTo((float)Math.Exp(power)).Within(1e-6).Percent, $"e^{power}");
            }
        }

        [Test]
        public void ExponentialAndLogarithm_AreWithinTwoUnits()
        {
            Assert.That(Worst(Elementary.Exp, Math.Exp, -1.0, 1.0), Is.LessThanOrEqualTo(2.0));
            Assert.That(Worst(Elementary.Exp, Math.Exp, -745.0, 709.0), Is.LessThanOrEqualTo(2.0));
            Assert.That(Worst(Elementary.Log, Math.Log, 0.5, 2.0), Is.LessThanOrEqualTo(2.0));
            Assert.That(Worst(Elementary.Log, Math.Log, 1e-9, 1e9), Is.LessThanOrEqualTo(2.0));
        }

        [TestCase(0.7, 0.01, 10.0)]
        [TestCase(-2.5, 0.5, 2.0)]
        [TestCase(12.0, 0.1, 30.0)]
        public void Powers_AreWithinWhatTheirSizeAllows(double power, double from, double to)
        {
            double most = 1.0 + 2.0 * Math.Max(Math.Abs(power * Math.Log(from)), Math.Abs(power * Math.Log(to)));
            Assert.That(Worst(x => Elementary.Pow(x, power), x => Math.Pow(x, power), from, to), Is.LessThanOrEqualTo(most));
        }

        [Test]
        public void Floats_AreTheRoundedTruth()
        {
            var random = new System.Random(3);
            for (int k = 0; k < k_Dense; k++)
            {
                float angle = (float)(200.0 * random.NextDouble() - 100.0), power = (float)(170.0 * random.NextDouble() - 85.0);
                Elementary.SinCos(angle, out float sin, out float cos);
                Assert.That(Off(sin, Math.Sin(angle)), Is.LessThan(0.51));
                Assert.That(Off(cos, Math.Cos(angle)), Is.LessThan(0.51));
                Assert.That(Off(Elementary.Exp(power), Math.Exp(power)), Is.LessThan(0.51));
                Assert.That(Off(Elementary.Atan2(sin, angle), Math.Atan2(sin, angle)), Is.LessThan(0.51));
            }
        }

        [Test]
        public void FourLanes_AreWithinTwoUnits()
        {
            for (int k = 0; k < k_Dense; k++)
            {
                float share = (k + 0.5f) / k_Dense, power = -87f + 175f * share, number = (float)Math.Exp(-60.0 + 120.0 * share);
                Assert.That(Off(SoaMath.Exp(power).y, Math.Exp(power)), Is.LessThan(2.0), $"exp {power}");
                Assert.That(Off(SoaMath.Log(number).z, Math.Log(number)), Is.LessThan(2.0), $"log {number}");
                float near = 0.5f + 1.5f * share;
                Assert.That(Off(SoaMath.Log(near).x, Math.Log(near)), Is.LessThan(2.0), $"log {near}");
                double most = 2.0 + 2.0 * Math.Abs(0.1 * Math.Log(number));
                Assert.That(Off(SoaMath.Pow(number, 0.1f).w, Math.Pow(number, 0.1f)), Is.LessThan(most));
            }
        }

        [Test]
        public void SpecialValues_AreThoseOfTheLibrary()
        {
            double[] values = { 0.0, -0.0, 1.0, -1.0, double.PositiveInfinity, double.NegativeInfinity, double.NaN, 1e308, -1e308, 5e-324 };
            foreach (double x in values)
            {
                Assert.That(Elementary.Exp(x), Is.EqualTo(Math.Exp(x)));
                Assert.That(Elementary.Log(x), Is.EqualTo(Math.Log(x)).Within(1).Ulps);
                foreach (double y in values)
                {
                    double ours = Elementary.Atan2(y, x), library = Math.Atan2(y, x);
                    Assert.That(ours, Is.EqualTo(library).Within(1).Ulps, $"atan2({y}, {x})");
                    Assert.That(double.IsNegative(ours), Is.EqualTo(double.IsNegative(library)), $"sign of atan2({y}, {x})");
                }
            }

            Assert.That(Elementary.Sin(double.PositiveInfinity), Is.NaN);
            Assert.That(Elementary.Acos(1.0000001), Is.NaN);
            Assert.That(Elementary.Pow(-2.0, 3.0), Is.EqualTo(-8.0).Within(4).Ulps);
            Assert.That(Elementary.Pow(-2.0, 0.5), Is.NaN);
            Assert.That(Elementary.Pow(0.0, 0.4), Is.Zero);
            Assert.That(SoaMath.Pow(0f, 0.4f).x, Is.Zero);
            float4 far = SoaMath.Exp(new float4(-1000f, 1000f, float.NaN, 0f));
            Assert.That(new[] { far.x, far.y, far.z, far.w }, Is.EqualTo(new[] { 0f, float.PositiveInfinity, float.NaN, 1f }));
        }

        [Test]
        public void HugeAngles_StayOnTheCircle([Values(1e7, 1e12, 1e18, 1e300)] double angle)
        {
            Elementary.SinCos(angle, out double sin, out double cos);
            Assert.That(sin * sin + cos * cos, Is.EqualTo(1.0).Within(1e-15));
        }

        [Test]
        public void Rotations_AreThoseOfTheMathematicsPackage()
        {
            var random = new Unity.Mathematics.Random(5);
            for (int k = 0; k < 1000; k++)
            {
                float angle = random.NextFloat(-7f, 7f);
                quaternion from = random.NextQuaternionRotation(), to = random.NextQuaternionRotation();
                AssertEqual(Rotations.AboutX(angle), quaternion.RotateX(angle));
                AssertEqual(Rotations.AboutY(angle), quaternion.RotateY(angle));
                AssertEqual(Rotations.Slerp(from, to, 0.3f), math.slerp(from, to, 0.3f));
            }
        }

        private static void AssertEqual(quaternion ours, quaternion theirs) =>
            Assert.That(math.cmax(math.abs(ours.value - theirs.value)), Is.LessThan(1e-6f));

        // Largest difference over the last place of the library's value, half of the arguments evenly spaced, half of them random.
        private static double Worst(Func<double, double> ours, Func<double, double> library, double from, double to)
        {
            var random = new System.Random(7);
            double worst = 0.0;
            for (int k = 0; k < k_Dense; k++)
            {
                double x = from + (to - from) * (k % 2 == 0 ? (double)k / k_Dense : random.NextDouble()), truth = library(x);
                long bits = BitConverter.DoubleToInt64Bits(Math.Abs(truth));
                double place = BitConverter.Int64BitsToDouble(bits + 1) - Math.Abs(truth), off = Math.Abs(ours(x) - truth) / place;
                worst = !(off <= worst) ? off : worst;
            }

            return worst;
        }

        // Difference of a float from the truth over the float's last place.
        private static double Off(float value, double truth)
        {
            float near = Math.Abs((float)truth);
            return Math.Abs(value - truth) / (math.asfloat(math.asint(near) + 1) - (double)near);
        }
    }
}
