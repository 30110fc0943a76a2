using System;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of curves through random landmarks.</summary>
    public sealed class MonotoneCurveLaws
    {
        private const double k_Bound = 1e-12;

        [Test]
        public void Curves_PassThroughTheirLandmarks_AndRunOneWayBetweenTwo()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                double[] spans = new double[random.NextInt(2, 12)], values = new double[spans.Length];
                for (int k = 0; k < spans.Length; k++)
                {
                    spans[k] = k == 0 ? random.NextFloat(-1f, 1f) : spans[k - 1] + Math.Exp(random.NextFloat(-4f, 1f));
                    values[k] = random.NextInt(4) == 0 && k > 0 ? values[k - 1] : random.NextFloat(-1f, 1f);
                }

                var straight = MonotoneCurve.Straight(spans, values);
                foreach (MonotoneCurve curve in new[] { straight, straight.Smoothed() })
                {
                    for (int k = 0; k + 1 < spans.Length; k++)
                        AssertOneWay(curve, spans[k], spans[k + 1], values[k], values[k + 1], $"seed {seed}, landmark {k}");
                    Assert.That(curve.At(spans[0] - 1.0), Is.EqualTo(values[0]), $"seed {seed}: before the first");
                    Assert.That(curve.At(spans[spans.Length - 1] + 1.0), Is.EqualTo(values[values.Length - 1]).Within(k_Bound),
                        $"seed {seed}: behind the last");
                }
            }
        }

        [Test]
        public void ASmoothedCurve_HasNoKinkAtItsLandmarks()
        {
            const double step = 1e-6;
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                double[] spans = { 0.0, 1.0, 1.0 + random.NextFloat(0.5f, 1.5f), 4.0 };
                double[] values = { random.NextDouble(), random.NextDouble(), random.NextDouble(), random.NextDouble() };
                MonotoneCurve curve = MonotoneCurve.Straight(spans, values).Smoothed();
                for (int k = 1; k < 3; k++)
                {
                    double at = curve.At(spans[k]), before = (at - curve.At(spans[k] - step)) / step,
                        after = (curve.At(spans[k] + step) - at) / step;
                    Assert.That(after, Is.EqualTo(before).Within(1e-4), $"seed {seed}, landmark {k}");
                }
            }
        }

        private static void AssertOneWay(MonotoneCurve curve, double from, double to, double first, double last, string message)
        {
            const int steps = 40;
            double way = Math.Sign(last - first), before = curve.At(from);
            Assert.That(before, Is.EqualTo(first).Within(k_Bound), message);
            for (int step = 1; step <= steps; step++)
            {
                double at = curve.At(from + (to - from) * step / steps);
                Assert.That(way != 0.0 ? way * (at - before) : -Math.Abs(at - before), Is.GreaterThanOrEqualTo(-k_Bound), message);
                before = at;
            }

            Assert.That(before, Is.EqualTo(last).Within(k_Bound), message);
        }
    }
}
