using System;
using System.Collections.Generic;
using Alate.Geometry;
using NUnit.Framework;
using Unity.Mathematics;
using Random = Unity.Mathematics.Random;

namespace Alate.Tests
{
    /// <summary>Laws of the plane of random wings, anywhere in space.</summary>
    public sealed class PlaneFitLaws
    {
        private const int k_Columns = 16, k_Rows = 6;

        [Test]
        public void AFlatWing_LiesInItsPlane_WhereverItIs() => AssertUpright(0f, 0f, 1e-4f);

        [Test]
        public void Pleats_DoNotTurnThePlane() => AssertUpright(0.1f, 0f, 1e-3f);

        [Test]
        public void CurvatureAlongTheSpan_DoesNotTurnThePlane() => AssertUpright(0f, 0.3f, 1e-3f);

        private static void AssertUpright(float pleat, float bow, float bound)
        {
            foreach (uint seed in Seeds.Usual)
            {
                var random = new Random(seed);
                float chord = random.NextFloat(0.15f, 0.6f), size = math.exp(random.NextFloat(-5f, 5f));
                quaternion turn = random.NextQuaternionRotation();
                float3 move = size * random.NextFloat3(-3f, 3f);
                float3[] points = Array.ConvertAll(Wing(chord, pleat, bow), point => move + size * math.rotate(turn, point));

                float3 normal = PlaneFit.Normal(points, Triangles());

                float3 up = math.rotate(turn, new float3(0f, 1f, 0f));
                Assert.That(math.length(math.cross(normal, up)), Is.LessThan(bound), $"seed {seed}");
                Assert.That(math.length(normal), Is.EqualTo(1f).Within(1e-5f), $"seed {seed}");
            }
        }

        // A rectangle, pleated along the span by a share of its chord and bowed evenly about its middle.
        private static float3[] Wing(float chord, float pleat, float bow)
        {
            var points = new float3[(k_Columns + 1) * (k_Rows + 1)];
            for (int k = 0; k < points.Length; k++)
            {
                int column = k / (k_Rows + 1), row = k % (k_Rows + 1);
                float x = (float)column / k_Columns - 0.5f;
                points[k] = new float3(x, pleat * chord * (row % 2) - bow * x * x, chord * row / k_Rows);
            }

            return points;
        }

        private static List<int3> Triangles()
        {
            var triangles = new List<int3>();
            for (int column = 0; column < k_Columns; column++)
            {
                for (int row = 0; row < k_Rows; row++)
                {
                    int at = column * (k_Rows + 1) + row, next = at + k_Rows + 1;
                    triangles.Add(new int3(at, at + 1, next));
                    triangles.Add(new int3(next, at + 1, next + 1));
                }
            }

            return triangles;
        }
    }
}
