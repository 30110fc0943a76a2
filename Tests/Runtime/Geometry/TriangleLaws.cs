using System;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of nearest places on triangles, against a search over the triangle, and of their quality.</summary>
    public sealed class TriangleLaws
    {
        private const int k_Steps = 60;

        [Test]
        public void TheNearestPlaceInPlan_IsTheOneThatASearchFinds_AndItsWeightsNameIt([Values] bool clockwise)
        {
            foreach (uint seed in Seeds.First(60))
            {
                var random = new Random(seed);
                PlanPoint a = Anywhere(ref random), b = Anywhere(ref random), c = Anywhere(ref random), p = Anywhere(ref random) * 2.0;
                if (Polygon.DoubledArea(a, b, c) > 0.0 == clockwise)
                    (b, c) = (c, b);
                var triangle = new PlanTriangle(a, b, c);
                double square = triangle.Closest(p, out double u, out double v, out double w), searched = double.MaxValue;
                for (int i = 0; i <= k_Steps; i++)
                {
                    for (int j = 0; i + j <= k_Steps; j++)
                        searched = Math.Min(searched, (At(a, b, c, (double)i / k_Steps, (double)j / k_Steps) - p).LengthSquared);
                }

                Assert.That(u + v + w, Is.EqualTo(1.0).Within(1e-12), $"seed {seed}");
                Assert.That(Math.Min(u, Math.Min(v, w)), Is.GreaterThanOrEqualTo(0.0), $"seed {seed}");
                Assert.That((a * u + b * v + c * w - p).LengthSquared, Is.EqualTo(square).Within(1e-12), $"seed {seed}");
                Assert.That(Math.Sqrt(square), Is.LessThanOrEqualTo(Math.Sqrt(searched) + 1e-9).And.GreaterThan(Math.Sqrt(searched) - 0.06),
                    $"seed {seed}");
                Assert.That(triangle.LeastDistanceSquared(p), Is.LessThanOrEqualTo(square + 1e-12), $"seed {seed}");
            }
        }

        [TestCase(0.25, 0.5, 0.0)]
        [TestCase(-1.0, 0.5, 1.0)]
        [TestCase(3.0, 0.5, 1.0)]
        [TestCase(1.0, -2.0, 4.0)]
        [TestCase(1.0, 3.0, 4.0)]
        [TestCase(4.0, 4.0, 13.0)]
        public void TheLeastDistance_IsThatFromTheRectangleAround(double x, double z, double square) =>
            Assert.That(
                new PlanTriangle(new PlanPoint(0, 1), new PlanPoint(2, 0), new PlanPoint(1, 1)).LeastDistanceSquared(new PlanPoint(x, z)),
                Is.EqualTo(square));

        [Test]
        public void ATriangleWithoutArea_IsTheLineOfItsCorners()
        {
            var line = new PlanTriangle(new PlanPoint(0, 0), new PlanPoint(1, 0), new PlanPoint(3, 0));

            Assert.That(line.Closest(new PlanPoint(2, 2), out double a, out double b, out double c), Is.EqualTo(4.0));
            Assert.That(b + 3.0 * c, Is.EqualTo(2.0).Within(1e-12));
            Assert.That(a + b + c, Is.EqualTo(1.0));
        }

        [Test]
        public void TheDistanceInSpace_IsTheOneThatASearchFinds()
        {
            foreach (uint seed in Seeds.First(60))
            {
                var random = new Random(seed);
                float3 a = random.NextFloat3(-1f, 1f), b = random.NextFloat3(-1f, 1f), c = random.NextFloat3(-1f, 1f),
                    p = random.NextFloat3(-2f, 2f);
                float searched = float.PositiveInfinity;
                for (int i = 0; i <= k_Steps; i++)
                {
                    for (int j = 0; i + j <= k_Steps; j++)
                        searched = math.min(searched, math.distance(p, a + (b - a) * i / k_Steps + (c - a) * j / k_Steps));
                }

                float distance = math.sqrt(TriangleDistance.Square(p, a, b, c));
                Assert.That(distance, Is.LessThanOrEqualTo(searched + 1e-5f).And.GreaterThan(searched - 0.06f), $"seed {seed}");
                Assert.That(
                    math.sqrt(TriangleDistance.Square(p, c, b, a)), Is.EqualTo(distance).Within(1e-4f), $"seed {seed}: either way round");
            }

            Assert.That(TriangleDistance.Square(new Vector3(0.2f, 0.3f, -0.5f), Vector3.zero, Vector3.right, Vector3.up),
                Is.EqualTo(0.25f).Within(1e-6f));
            Assert.That(TriangleDistance.Square(Vector3.up, Vector3.zero, Vector3.right, Vector3.right), Is.EqualTo(1f), "without area");
        }

        [Test]
        public void Quality_IsOneForEqualSides_WhateverTheirLength_AndChangesSignWithTheTurn()
        {
            PlanPoint a = new PlanPoint(1, 1), b = new PlanPoint(4, 1), c = new PlanPoint(2.5, 1 + 1.5 * Math.Sqrt(3.0));

            Assert.That(TriangleSmoothing.Quality(a, b, c), Is.EqualTo(1.0).Within(1e-12));
            Assert.That(TriangleSmoothing.Quality(a * 7.0, b * 7.0, c * 7.0), Is.EqualTo(1.0).Within(1e-12));
            Assert.That(TriangleSmoothing.Quality(a, c, b), Is.EqualTo(-1.0).Within(1e-12));
            Assert.That(TriangleSmoothing.Quality(a, b, new PlanPoint(9, 1)), Is.Zero);

            // Half a square: area 1/2, squared sides 1 + 1 + 2.
            Assert.That(
                TriangleSmoothing.Quality(default, new PlanPoint(1, 0), new PlanPoint(0, 1)), Is.EqualTo(Math.Sqrt(0.75)).Within(1e-12));
        }

        [Test]
        public void Directions_AreUnitVectors_HoweverLongTheVectorWas([Values(1e-30f, 1f, 1e30f)] float length)
        {
            Vector3 unit = Directions.Unit(length * new Vector3(2f, -3f, 6f));

            Assert.That(Vector3.Distance(unit, new Vector3(2f, -3f, 6f) / 7f), Is.LessThan(1e-6f));
        }

        private static PlanPoint At(PlanPoint a, PlanPoint b, PlanPoint c, double v, double w) => a + (b - a) * v + (c - a) * w;

        private static PlanPoint Anywhere(ref Random random) => new PlanPoint(random.NextFloat(-1f, 1f), random.NextFloat(-1f, 1f));
    }
}
