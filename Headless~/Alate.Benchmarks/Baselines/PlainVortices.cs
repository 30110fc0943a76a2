using Unity.Mathematics;

namespace Alate.Benchmarks;

/// <summary>
/// Velocities induced by vortex segments as one would write them first: in double precision, a segment and a point at a time.
/// </summary>
internal static class PlainVortices
{
    /// <summary>Adds up what a chain of segments induces at points.</summary>
    /// <param name="chain">[vertex · 3 + axis] Vertices.</param>
    /// <param name="circulation">Γ of all segments.</param>
    /// <param name="coreSquare">rc².</param>
    /// <param name="points">[point · 3 + axis] Points.</param>
    /// <param name="velocities">[point · 3 + axis] Velocities.</param>
    public static void Induce(double[] chain, double circulation, double coreSquare, double[] points, double[] velocities)
    {
        for (int p = 0; p < points.Length; p += 3)
        {
            double u = 0.0, v = 0.0, w = 0.0;
            for (int k = 3; k < chain.Length; k += 3)
            {
                double ax = points[p] - chain[k - 3], ay = points[p + 1] - chain[k - 2], az = points[p + 2] - chain[k - 1];
                double bx = points[p] - chain[k], by = points[p + 1] - chain[k + 1], bz = points[p + 2] - chain[k + 2];
                double rx = chain[k] - chain[k - 3], ry = chain[k + 1] - chain[k - 2], rz = chain[k + 2] - chain[k - 1];
                double cx = ay * bz - az * by, cy = az * bx - ax * bz, cz = ax * by - ay * bx;
                double square = cx * cx + cy * cy + cz * cz, length = rx * rx + ry * ry + rz * rz;
                double d = (rx * ax + ry * ay + rz * az) / math.sqrt(ax * ax + ay * ay + az * az)
                    - (rx * bx + ry * by + rz * bz) / math.sqrt(bx * bx + by * by + bz * bz);
                double factor = circulation / (4.0 * math.PI_DBL) * d
                    / math.sqrt(square * square + coreSquare * coreSquare * length * length);
                u += factor * cx;
                v += factor * cy;
                w += factor * cz;
            }

            velocities[p] = u;
            velocities[p + 1] = v;
            velocities[p + 2] = w;
        }
    }
}
