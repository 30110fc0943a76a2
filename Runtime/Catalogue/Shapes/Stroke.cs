using System;

namespace Alate.Catalogue
{
    /// <summary>A straight piece of a polyline in the plane of the wing.</summary>
    internal readonly struct Stroke
    {
        public readonly double x, z, dx, dz, length;

        /// <summary>Distance along the polyline at which the piece begins.</summary>
        public readonly double start;

        private readonly double m_PerLengthSquared;

        public Stroke(double x0, double z0, double x1, double z1, double start)
        {
            x = x0;
            z = z0;
            dx = x1 - x0;
            dz = z1 - z0;
            length = Math.Sqrt(dx * dx + dz * dz);
            m_PerLengthSquared = length > 0 ? 1 / (length * length) : 0;
            this.start = start;
        }

        /// <summary>Squared distance of a place from the piece, with the distance along the polyline of the nearest point.</summary>
        public double DistanceSquared(double placeX, double placeZ, out double along)
        {
            double t = Math.Clamp(((placeX - x) * dx + (placeZ - z) * dz) * m_PerLengthSquared, 0, 1);
            double offX = placeX - x - t * dx, offZ = placeZ - z - t * dz;
            along = start + t * length;
            return offX * offX + offZ * offZ;
        }
    }
}
