using System.Collections.Generic;
using System.Linq;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests.Geometry
{
    /// <summary>Laws of sums of squared distances.</summary>
    public sealed class QuadricLaws
    {
        [Test]
        public void AQuadric_IsTheSumOfSquaredDistancesFromItsPlanesAndPoints()
        {
            var random = new Random(3u);
            var planes = new List<(float3 Normal, double D, double Weight)>();
            Quadric half = default, other = default;
            for (int k = 0; k < 6; k++)
            {
                float3 normal = random.NextFloat3Direction();
                (float3 Normal, double D, double Weight) plane = (normal, 4.0 * random.NextDouble() - 2.0, 0.1 + 3.0 * random.NextDouble());
                planes.Add(plane);
                if (k < 3)
                    half.Add(normal.x, normal.y, normal.z, plane.D, plane.Weight);
                else
                    other.Add(normal.x, normal.y, normal.z, plane.D, plane.Weight);
            }

            half.Add(other);
            float3 point = random.NextFloat3(-2f, 2f);
            half.AddPoint(point, 0.7);
            for (int k = 0; k < 20; k++)
            {
                float3 place = random.NextFloat3(-3f, 3f);
                double wanted = planes.Sum(plane => plane.Weight * Square(
                    (double)plane.Normal.x * place.x + (double)plane.Normal.y * place.y + (double)plane.Normal.z * place.z + plane.D))
                    + 0.7 * (Square((double)place.x - point.x) + Square((double)place.y - point.y) + Square((double)place.z - point.z));
                Assert.That(half.At(place), Is.EqualTo(wanted).Within(1e-10 * wanted));
            }
        }

        private static double Square(double value) => value * value;
    }
}
