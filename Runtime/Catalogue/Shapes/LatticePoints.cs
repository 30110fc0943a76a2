using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>Points of a lattice of equilateral triangles that lie inside a polygon, away from its rim, an exact number of them.</summary>
    internal sealed class LatticePoints
    {
        /// <summary>Least distance from the rim over the lattice's spacing: nearer points would make flat triangles.</summary>
        private const double k_Clearance = 0.55;

        /// <summary>Distance from a row over the spacing up to which the rim is looked at.</summary>
        private const double k_Sight = 1.0;

        private const double k_Shrink = 0.985;

        private readonly IReadOnlyList<PlanPoint> m_Polygon;
        private readonly double m_Spacing;
        private readonly PlanPoint m_Low;
        private readonly PlanPoint m_High;
        private readonly List<PlanPoint> m_Points = new List<PlanPoint>();

        /// <summary>[point] Squared distance from the rim, as far as it was seen.</summary>
        private readonly List<double> m_Distances = new List<double>();

        private LatticePoints(IReadOnlyList<PlanPoint> polygon, double spacing)
        {
            m_Polygon = polygon;
            m_Spacing = spacing;
            m_Low = m_High = polygon[0];
            foreach (var corner in polygon)
            {
                m_Low = new PlanPoint(Math.Min(m_Low.x, corner.x), Math.Min(m_Low.z, corner.z));
                m_High = new PlanPoint(Math.Max(m_High.x, corner.x), Math.Max(m_High.z, corner.z));
            }

            Collect();
        }

        /// <param name="polygon">A simple polygon.</param>
        /// <param name="count">Points to make.</param>
        /// <param name="spacing">Spacing to begin with; it shrinks until there are enough points, and those nearest to the rim are left out again.</param>
        public static PlanPoint[] Inside(IReadOnlyList<PlanPoint> polygon, int count, double spacing)
        {
            var lattice = new LatticePoints(polygon, spacing);
            while (lattice.m_Points.Count < count)
            {
                spacing *= k_Shrink;
                lattice = new LatticePoints(polygon, spacing);
            }

            return lattice.Farthest(count);
        }

        private void Collect()
        {
            var height = m_Spacing * Math.Sqrt(0.75);
            var rows = (int)Math.Ceiling((m_High.z - m_Low.z) / height);
            var columns = (int)Math.Ceiling((m_High.x - m_Low.x) / m_Spacing);
            var near = new List<int>();
            for (var row = 0; row < rows; row++)
            {
                var z = m_Low.z + (row + 0.5) * height;
                FindNear(z, near);
                for (var column = 0; column <= columns; column++)
                {
                    // Each row starts where the last one ended, so that neighbours in the list are neighbours in the plan.
                    var along = row % 2 == 0 ? column : columns - column;
                    Consider(new PlanPoint(m_Low.x + (along + 0.5 * (row % 2)) * m_Spacing, z), near);
                }
            }
        }

        private void FindNear(double z, List<int> near)
        {
            near.Clear();
            var sight = k_Sight * m_Spacing;
            for (var k = 0; k < m_Polygon.Count; k++)
            {
                if (Math.Min(m_Polygon[k].z, End(k).z) < z + sight && Math.Max(m_Polygon[k].z, End(k).z) > z - sight)
                {
                    near.Add(k);
                }
            }
        }

        private void Consider(PlanPoint point, List<int> near)
        {
            var inside = false;
            var least = double.PositiveInfinity;
            foreach (var k in near)
            {
                var a = m_Polygon[k];
                var b = End(k);
                least = Math.Min(least, PlanPoint.DistanceSquared(point, a, b));
                inside ^= a.z > point.z != b.z > point.z && point.x < a.x + (b.x - a.x) * (point.z - a.z) / (b.z - a.z);
            }

            if (inside && least > k_Clearance * k_Clearance * m_Spacing * m_Spacing)
            {
                m_Points.Add(point);
                m_Distances.Add(least);
            }
        }

        private PlanPoint[] Farthest(int count)
        {
            var order = new int[m_Points.Count];
            for (var k = 0; k < order.Length; k++)
            {
                order[k] = k;
            }

            Array.Sort(m_Distances.ToArray(), order);
            var kept = order.AsSpan(order.Length - count).ToArray();
            Array.Sort(kept);
            return Array.ConvertAll(kept, k => m_Points[k]);
        }

        private PlanPoint End(int side) => m_Polygon[side + 1 == m_Polygon.Count ? 0 : side + 1];
    }
}
