using System;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>A symmetric 3 × 3 matrix as its upper triangle: xx, xy, xz, yy, yz, zz.</summary>
    internal static class SymmetricMatrix
    {
        private const int k_Sweeps = 24;

        /// <summary>The unit eigenvector of the largest eigenvalue, by Jacobi's rotations.</summary>
        public static float3 LargestDirection(double[] upper)
        {
            double[,] a =
            {
                { upper[0], upper[1], upper[2] }, { upper[1], upper[3], upper[4] }, { upper[2], upper[4], upper[5] },
            };
            double[,] vectors = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
            for (int sweep = 0; sweep < k_Sweeps; sweep++)
            {
                Rotate(a, vectors, 0, 1);
                Rotate(a, vectors, 0, 2);
                Rotate(a, vectors, 1, 2);
            }

            int largest = a[0, 0] >= a[1, 1] ? 0 : 1;
            largest = a[largest, largest] >= a[2, 2] ? largest : 2;
            return math.normalize(
                new float3((float)vectors[0, largest], (float)vectors[1, largest], (float)vectors[2, largest]));
        }

        // Turns the axes p and q so that a[p, q] vanishes.
        private static void Rotate(double[,] a, double[,] vectors, int p, int q)
        {
            if (a[p, q] == 0.0)
                return;
            double theta = 0.5 * (a[q, q] - a[p, p]) / a[p, q];
            double tangent = (theta < 0.0 ? -1.0 : 1.0) / (Math.Abs(theta) + Math.Sqrt(theta * theta + 1.0));
            double cosine = 1.0 / Math.Sqrt(tangent * tangent + 1.0), sine = tangent * cosine;
            for (int k = 0; k < 3; k++)
            {
                double kp = a[k, p], kq = a[k, q];
                a[k, p] = cosine * kp - sine * kq;
                a[k, q] = sine * kp + cosine * kq;
            }

            for (int k = 0; k < 3; k++)
            {
                double pk = a[p, k], qk = a[q, k], vp = vectors[k, p], vq = vectors[k, q];
                a[p, k] = cosine * pk - sine * qk;
                a[q, k] = sine * pk + cosine * qk;
                vectors[k, p] = cosine * vp - sine * vq;
                vectors[k, q] = sine * vp + cosine * vq;
            }
        }
    }
}
