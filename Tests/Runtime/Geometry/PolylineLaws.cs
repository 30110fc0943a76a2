using System;
using Alate.Geometry;
using NUnit.Framework;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of walks along random stars: lines open and closed, and the curve resampled from them.</summary>
    public sealed class PolylineLaws
    {
        private const double k_Bound = 1e-9;

        [Test]
        public void ALine_PassesItsPointsAtTheirDistances([Values] bool isClosed)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                var line = new Polyline(star, isClosed);

                Assert.That(line.Length, Is.EqualTo(Polyline.LengthOf(star, isClosed)).Within(k_Bound), $"seed {seed}");
                for (int k = 0; k < star.Length; k++)
                    Assert.That(Distance(line.At(line.DistanceTo(k)), star[k]), Is.LessThan(k_Bound), $"seed {seed}, point {k}");
                Assert.That(
                    Distance(line.At(line.Length), isClosed ? star[0] : star[star.Length - 1]), Is.LessThan(k_Bound), $"seed {seed}");
            }
        }

        [Test]
        public void TheNearestPlace_IsAsFarAsTheLine([Values] bool isClosed)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                var line = new Polyline(star, isClosed);
                for (int k = 0; k < 20; k++)
                {
                    PlanPoint point = Anywhere(ref random);
                    Assert.That(
                        Distance(line.At(line.Nearest(point)), point), Is.EqualTo(Polyline.Distance(star, point, isClosed)).Within(k_Bound),
                        $"seed {seed}, place {k}");
                }
            }
        }

        [Test]
        public void AClosedCurve_WrapsRound_AtTheArcLengthsOfItsOutline()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                PlanPoint[] star = Star(ref random);
                var curve = new ClosedCurve(star, 400);

                Assert.That(curve.Length, Is.EqualTo(Polyline.LengthOf(star, true)).Within(k_Bound), $"seed {seed}");
                Assert.That(curve.Line.Length, Is.LessThanOrEqualTo(curve.Length + k_Bound), $"seed {seed}: chords are shorter");
                for (int k = 0; k < curve.Samples.Count; k++)
                {
                    Assert.That(Distance(curve.At(k * curve.Step), curve.Samples[k]), Is.LessThan(k_Bound), $"seed {seed}, sample {k}");
                    Assert.That(Polyline.Distance(star, curve.Samples[k], true), Is.LessThan(k_Bound), $"seed {seed}, sample {k}");
                }

                double s = random.NextDouble() * curve.Length;
                Assert.That(Distance(curve.At(s + 2.0 * curve.Length), curve.At(s)), Is.LessThan(k_Bound), $"seed {seed}");
                Assert.That(Distance(curve.At(s - curve.Length), curve.At(s)), Is.LessThan(k_Bound), $"seed {seed}");
            }
        }

        [Test]
        public void AClosedCurve_FindsNearestPlaceAndInside_AsItsSamplesDo()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                var curve = new ClosedCurve(Star(ref random), 400);
                for (int k = 0; k < 20; k++)
                {
                    PlanPoint point = Anywhere(ref random);
                    double least = Polyline.Distance(curve.Samples, point, true);
                    Assert.That(
                        Distance(curve.At(curve.Nearest(point)), point), Is.EqualTo(least).Within(k_Bound), $"seed {seed}, place {k}");
                    Assert.That(curve.Contains(point), Is.EqualTo(Polygon.Contains(curve.Samples, point)), $"seed {seed}, place {k}");
                }
            }
        }

        // Counterclockwise round the origin.
        private static PlanPoint[] Star(ref Random random)
        {
            var star = new PlanPoint[random.NextInt(3, 40)];
            for (int k = 0; k < star.Length; k++)
            {
                double angle = 2.0 * Math.PI * k / star.Length;
                star[k] = new PlanPoint(Math.Cos(angle), Math.Sin(angle)) * random.NextFloat(0.2f, 1f);
            }

            return star;
        }

        private static PlanPoint Anywhere(ref Random random) => new PlanPoint(random.NextFloat(-1.5f, 1.5f), random.NextFloat(-1.5f, 1.5f));

        private static double Distance(PlanPoint a, PlanPoint b) => Math.Sqrt((a - b).LengthSquared);
    }
}
