using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>A polyline in the plane of the wing, walked by its arc length.</summary>
    internal sealed class PlanarPath
    {
        private readonly List<(double X, double Z)> m_Points = new List<(double X, double Z)>();
        private readonly List<double> m_Distances = new List<double>();

        public double Length => m_Distances.Count == 0 ? 0 : m_Distances[m_Distances.Count - 1];

        public List<PlanPoint> Points => m_Points.ConvertAll(p => new PlanPoint(p.X, p.Z));

        /// <summary>The straight path between two points.</summary>
        public static PlanarPath Line((double X, double Z) from, (double X, double Z) to)
        {
            var path = new PlanarPath();
            path.Add(from.X, from.Z);
            path.Add(to.X, to.Z);
            return path;
        }

        /// <summary>Paths one after the other; a point where two meet is one point.</summary>
        public static PlanarPath Join(params PlanarPath[] parts)
        {
            var path = new PlanarPath();
            foreach (var part in parts)
            {
                foreach (var (x, z) in part.m_Points)
                {
                    var count = path.m_Points.Count;
                    if (count == 0 || path.m_Points[count - 1] != (x, z))
                    {
                        path.Add(x, z);
                    }
                }
            }

            return path;
        }

        public void Add(double x, double z)
        {
            var distance = 0.0;
            if (m_Points.Count > 0)
            {
                var (lastX, lastZ) = m_Points[m_Points.Count - 1];
                distance = Length + Math.Sqrt((x - lastX) * (x - lastX) + (z - lastZ) * (z - lastZ));
            }

            m_Points.Add((x, z));
            m_Distances.Add(distance);
        }

        /// <summary>The path up to a distance.</summary>
        public PlanarPath Until(double distance)
        {
            var path = new PlanarPath();
            for (var k = 0; k < m_Points.Count && m_Distances[k] < distance; k++)
            {
                path.Add(m_Points[k].X, m_Points[k].Z);
            }

            var (x, z) = At(distance);
            path.Add(x, z);
            return path;
        }

        public (double X, double Z) At(double distance)
        {
            var found = m_Distances.BinarySearch(distance);
            if (found >= 0)
            {
                return m_Points[found];
            }

            var after = Math.Clamp(~found, 1, m_Points.Count - 1);
            var stretch = m_Distances[after] - m_Distances[after - 1];
            var t = stretch > 0 ? Math.Clamp((distance - m_Distances[after - 1]) / stretch, 0, 1) : 0;
            var (x0, z0) = m_Points[after - 1];
            var (x1, z1) = m_Points[after];
            return (x0 + t * (x1 - x0), z0 + t * (z1 - z0));
        }
    }
}
