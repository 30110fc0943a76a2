using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>Polylines in the plane of the wing, asked for the distance to the nearest of them.</summary>
    internal sealed class StrokeSet
    {
        private readonly List<(double X0, double Z0, double X1, double Z1, double Start)> m_Segments =
            new List<(double X0, double Z0, double X1, double Z1, double Start)>();

        /// <summary>Adds a polyline given as x, z, x, z, …; Start of its segments counts on from <paramref name="start"/>.</summary>
        public StrokeSet Add(IReadOnlyList<double> coordinates, double start = 0)
        {
            for (var i = 0; i + 3 < coordinates.Count; i += 2)
            {
                m_Segments.Add((coordinates[i], coordinates[i + 1], coordinates[i + 2], coordinates[i + 3], start));
                start += Hypotenuse(coordinates[i + 2] - coordinates[i], coordinates[i + 3] - coordinates[i + 1]);
            }

            return this;
        }

        /// <summary>Distance to the nearest segment, and how far along its polyline the nearest point lies.</summary>
        public double Distance(double x, double z, out double along)
        {
            var nearest = double.MaxValue;
            along = 0;
            foreach (var (x0, z0, x1, z1, start) in m_Segments)
            {
                var dx = x1 - x0;
                var dz = z1 - z0;
                var length = Hypotenuse(dx, dz);
                var t = length > 0 ? Math.Clamp(((x - x0) * dx + (z - z0) * dz) / (length * length), 0, 1) : 0;
                var distance = Hypotenuse(x - x0 - t * dx, z - z0 - t * dz);
                if (distance < nearest)
                {
                    nearest = distance;
                    along = start + t * length;
                }
            }

            return nearest;
        }

        private static double Hypotenuse(double a, double b) => Math.Sqrt(a * a + b * b);
    }
}
