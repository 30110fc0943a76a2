using System;

namespace Alate.Catalogue
{
    /// <summary>A straight piece of a polyline in the plane of the wing.</summary>
    internal readonly struct Stroke
    {
        public readonly double x, z, dx, dz, length;

        /// <summary>How far along its polyline it begins.</summary>
        public readonly double start;

        public Stroke(double x0, double z0, double x1, double z1, double start)
        {
            x = x0;
            z = z0;
            dx = x1 - x0;
            dz = z1 - z0;
            length = Math.Sqrt(dx * dx + dz * dz);
            this.start = start;
        }

        /// <summary>Distance of a place, and how far along the polyline the nearest point lies.</summary>
        public double Distance(double placeX, double placeZ, out double along)
        {
            var t = length > 0 ? Math.Clamp(((placeX - x) * dx + (placeZ - z) * dz) / (length * length), 0, 1) : 0;
            double offX = placeX - x - t * dx, offZ = placeZ - z - t * dz;
            along = start + t * length;
            return Math.Sqrt(offX * offX + offZ * offZ);
        }
    }
}
