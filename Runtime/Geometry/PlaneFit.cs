using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>
    /// Finds the plane in which a wing is seen largest and flattest. Its normal n maximises the mean of (n·triangle normal)² less the share
    /// of the wing's spread along n: the first term alone fails on pleats, the second on slender wings that are curved along the span.
    /// </summary>
    internal static class PlaneFit
    {
        /// <summary>Unit normal of the plane, of either sign.</summary>
        public static float3 Normal(float3[] points, IReadOnlyList<int3> triangles)
        {
            double[] facing = new double[6];
            double[] spread = new double[6];
            double[] centre = new double[3];
            double area = 0.0;
            foreach (int3 t in triangles)
                area += AddCentre(points[t.x], points[t.y], points[t.z], centre);
            var middle = new float3((float)(centre[0] / area), (float)(centre[1] / area), (float)(centre[2] / area));
            foreach (int3 t in triangles)
                AddMoments(points[t.x] - middle, points[t.y] - middle, points[t.z] - middle, facing, spread);

            double trace = spread[0] + spread[3] + spread[5];
            double[] matrix = new double[6];
            for (int k = 0; k < 6; k++)
                matrix[k] = facing[k] / area - spread[k] / trace;
            return SymmetricMatrix.LargestDirection(matrix);
        }

        private static double AddCentre(float3 a, float3 b, float3 c, double[] centre)
        {
            double area = 0.5 * math.length(math.cross(b - a, c - a));
            float3 third = (a + b + c) / 3f;
            centre[0] += area * third.x;
            centre[1] += area * third.y;
            centre[2] += area * third.z;
            return area;
        }

        // ∫ p pᵀ dA = A/12 (a aᵀ + b bᵀ + c cᵀ + s sᵀ) over a triangle, s = a + b + c.
        private static void AddMoments(float3 a, float3 b, float3 c, double[] facing, double[] spread)
        {
            float3 normal = math.cross(b - a, c - a);
            double doubled = math.length(normal);
            if (doubled <= 0.0)
                return;
            AddSquare(facing, normal, 0.5 / doubled);
            double twelfth = 0.5 * doubled / 12.0;
            AddSquare(spread, a, twelfth);
            AddSquare(spread, b, twelfth);
            AddSquare(spread, c, twelfth);
            AddSquare(spread, a + b + c, twelfth);
        }

        private static void AddSquare(double[] sum, float3 v, double factor)
        {
            sum[0] += factor * v.x * v.x;
            sum[1] += factor * v.x * v.y;
            sum[2] += factor * v.x * v.z;
            sum[3] += factor * v.y * v.y;
            sum[4] += factor * v.y * v.z;
            sum[5] += factor * v.z * v.z;
        }
    }
}
