using System;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using UnityEngine;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of welded vertices over random clouds, against a search through all pairs.</summary>
    public sealed class VertexWeldLaws
    {
        [Test]
        public void Exact_FindsTheFirstVertexAtThePlace_AndTakesMinusZeroForZero()
        {
            float[] coordinates = { -1f, -0f, 0f, 1f, 1.0000001f };
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                var points = new float3[random.NextInt(1, 200)];
                for (int k = 0; k < points.Length; k++)
                    points[k] = new float3(coordinates[random.NextInt(5)], coordinates[random.NextInt(5)], coordinates[random.NextInt(5)]);

                int[] places = VertexWeld.Exact(points);

                for (int k = 0; k < points.Length; k++)
                {
                    Assert.That(
                        places[k], Is.EqualTo(Array.FindIndex(points, point => math.all(point == points[k]))), $"seed {seed}, vertex {k}");
                }
            }
        }

        [TestCase(1000f, 0.95e-3f, true)]
        [TestCase(1000f, 1.06e-3f, false)]
        [TestCase(0.001f, 0.95e-9f, true)]
        [TestCase(0.001f, 1.06e-9f, false)]
        public void Join_TiesVerticesWithinAMillionthOfTheLargestCoordinate(float size, float apart, bool isJoined)
        {
            Vector3[] positions = new[] { new Vector3(0f, 0f, 0f), new Vector3(0f, -size, 0f), new Vector3(apart, 0f, 0f),
                new Vector3(float.NaN, 0f, 0f), new Vector3(0f, 0f, 0f), new Vector3(7f * size, 0f, 0f) };
            var sets = new DisjointSets(6);

            // The last two are not used, the one before is no place.
            VertexWeld.Join(positions, new[] { 0, 1, 2, 3 }, sets);
            Assert.That(Enumerable.Range(0, 6).Select(vertex => sets.Find(vertex)), Is.EqualTo(new[] { 0, 1, isJoined ? 0 : 2, 3, 4, 5 }));
        }

        [Test]
        public void Places_FindsTheFirstVertexWithinTheTolerance_ThatIsAPlaceItself()
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float tolerance = math.exp(random.NextFloat(-9f, 0f)), extent = tolerance * random.NextFloat(1f, 200f);
                var points = new float3[random.NextInt(1, 200)];
                for (int k = 0; k < points.Length; k++)
                {
                    points[k] = k > 0 && random.NextBool()
                        ? points[random.NextInt(k)] + random.NextFloat3(-tolerance, tolerance)
                        : random.NextFloat3(-extent, extent);
                }

                int[] places = VertexWeld.Places(points, tolerance);

                for (int k = 0; k < points.Length; k++)
                {
                    int first = 0;
                    while (first < k && (places[first] != first || math.distancesq(points[first], points[k]) > tolerance * tolerance))
                        first++;
                    Assert.That(places[k], Is.EqualTo(first), $"seed {seed}, vertex {k}");
                }
            }
        }
    }
}
