using System;
using System.Collections.Generic;

namespace Alate
{
    /// <summary>Points of a lattice of equilateral triangles that lie inside a polygon, away from its rim, an exact number of them.</summary>
    sealed class LatticePoints
    {
        /// <summary>Least distance from the rim over the lattice's spacing: nearer ones would make flat triangles.</summary>
        const double k_Clearance = 0.55;

        const double k_Shrink = 0.985;

        readonly IReadOnlyList<PlanPoint> m_Polygon;
        readonly PlanPoint m_Low;
        readonly PlanPoint m_High;

        LatticePoints(IReadOnlyList<PlanPoint> polygon)
        {
            m_Polygon = polygon;
            m_Low = m_High = polygon[0];
            foreach (var corner in polygon)
            {
                m_Low = new PlanPoint(Math.Min(m_Low.x, corner.x), Math.Min(m_Low.z, corner.z));
                m_High = new PlanPoint(Math.Max(m_High.x, corner.x), Math.Max(m_High.z, corner.z));
            }
        }

        /// <param name="polygon">A simple polygon.</param>
        /// <param name="count">Points to make.</param>
        /// <param name="spacing">Spacing to begin with; it shrinks until there are enough points, and those nearest to the rim are left out again.</param>
        public static List<PlanPoint> Inside(IReadOnlyList<PlanPoint> polygon, int count, double spacing)
        {
            var lattice = new LatticePoints(polygon);
            var found = lattice.Collect(spacing);
            while (found.Count < count)
            {
                spacing *= k_Shrink;
                found = lattice.Collect(spacing);
            }

            return lattice.WithoutNearest(found, found.Count - count);
        }

        List<PlanPoint> Collect(double spacing)
        {
            var points = new List<PlanPoint>();
            var height = spacing * Math.Sqrt(0.75);
            var rows = (int)Math.Ceiling((m_High.z - m_Low.z) / height);
            var columns = (int)Math.Ceiling((m_High.x - m_Low.x) / spacing);
            for (var row = 0; row < rows; row++)
            {
                for (var column = 0; column <= columns; column++)
                {
                    // Each row starts where the last one ended, so that neighbours in the list are neighbours in the plan.
                    var along = row % 2 == 0 ? column : columns - column;
                    var point = new PlanPoint(m_Low.x + (along + 0.5 * (row % 2)) * spacing, m_Low.z + (row + 0.5) * height);
                    if (IsInside(point) && DistanceSquared(point) > k_Clearance * k_Clearance * spacing * spacing)
                    {
                        points.Add(point);
                    }
                }
            }

            return points;
        }

        List<PlanPoint> WithoutNearest(List<PlanPoint> points, int excess)
        {
            var order = new int[points.Count];
            for (var k = 0; k < order.Length; k++)
            {
                order[k] = k;
            }

            Array.Sort(points.ConvertAll(DistanceSquared).ToArray(), order);
            var left = order.AsSpan(excess).ToArray();
            Array.Sort(left);
            return new List<PlanPoint>(Array.ConvertAll(left, k => points[k]));
        }

        bool IsInside(PlanPoint point)
        {
            var inside = false;
            for (var k = 0; k < m_Polygon.Count; k++)
            {
                var a = m_Polygon[k];
                var b = m_Polygon[k + 1 == m_Polygon.Count ? 0 : k + 1];
                if (a.z > point.z != b.z > point.z && point.x < a.x + (b.x - a.x) * (point.z - a.z) / (b.z - a.z))
                {
                    inside = !inside;
                }
            }

            return inside;
        }

        double DistanceSquared(PlanPoint point)
        {
            var least = double.PositiveInfinity;
            for (var k = 0; k < m_Polygon.Count; k++)
            {
                least = Math.Min(least, PlanPoint.DistanceSquared(point, m_Polygon[k], m_Polygon[k + 1 == m_Polygon.Count ? 0 : k + 1]));
            }

            return least;
        }
    }
}
