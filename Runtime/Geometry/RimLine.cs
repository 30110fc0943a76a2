using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>An outline walked by its length.</summary>
    internal sealed class RimLine
    {
        private readonly PlanPoint[] m_Points;
        private readonly double[] m_Lengths;

        /// <param name="points">Closed; the last is joined to the first.</param>
        public RimLine(PlanPoint[] points)
        {
            m_Points = points;
            m_Lengths = new double[points.Length + 1];
            for (int k = 0; k < points.Length; k++)
                m_Lengths[k + 1] = m_Lengths[k] + Math.Sqrt((points[(k + 1) % points.Length] - points[k]).LengthSquared);
        }

        public IReadOnlyList<PlanPoint> Points => m_Points;

        /// <summary>Length all around.</summary>
        public double Length => m_Lengths[m_Points.Length];

        public PlanPoint this[int point] => m_Points[point % m_Points.Length];

        /// <summary>Distance along the outline of one of its points.</summary>
        public double DistanceTo(int point) => m_Lengths[point];

        /// <summary>The place at a distance along the outline, from 0 to its length.</summary>
        public PlanPoint At(double distance)
        {
            int segment = SegmentAt(distance);
            double length = Math.Max(m_Lengths[segment + 1] - m_Lengths[segment], double.Epsilon);
            return this[segment] + (this[segment + 1] - this[segment]) * ((distance - m_Lengths[segment]) / length);
        }

        /// <summary>The point before a distance along the outline.</summary>
        public int SegmentAt(double distance)
        {
            int found = Array.BinarySearch(m_Lengths, distance);
            return Math.Min(m_Points.Length - 1, Math.Max(0, found >= 0 ? found : ~found - 1));
        }

        /// <summary>Unit direction from a point to the next.</summary>
        public PlanPoint Direction(int segment)
        {
            PlanPoint along = this[segment + 1] - this[segment];
            return along * (1.0 / Math.Max(Math.Sqrt(along.LengthSquared), double.Epsilon));
        }

        /// <summary>Distance along the outline of its place closest to a point.</summary>
        public double Nearest(PlanPoint point)
        {
            double best = double.MaxValue, at = 0.0;
            for (int k = 0; k < m_Points.Length; k++)
            {
                double along = PlanPoint.ClosestOnSegment(point, this[k], this[k + 1]);
                double distance = (this[k] + (this[k + 1] - this[k]) * along - point).LengthSquared;
                if (distance < best)
                    (best, at) = (distance, m_Lengths[k] + along * (m_Lengths[k + 1] - m_Lengths[k]));
            }

            return at;
        }

        /// <summary>How far a ray goes until it first meets the outline, leaving out one segment; <see cref="double.MaxValue"/> when it never does.</summary>
        /// <param name="from">Where it begins.</param>
        /// <param name="direction">A unit vector.</param>
        /// <param name="skipped">The segment on which the ray begins, or −1.</param>
        /// <param name="met">The segment it meets.</param>
        public double Meet(PlanPoint from, PlanPoint direction, int skipped, out int met)
        {
            double nearest = double.MaxValue;
            met = -1;
            for (int k = 0; k < m_Points.Length; k++)
            {
                PlanPoint a = this[k] - from, b = this[k + 1] - from;
                double sideA = PlanPoint.Cross(direction, a), sideB = PlanPoint.Cross(direction, b);
                if (k == skipped || sideA > 0.0 == sideB > 0.0)
                    continue;
                double reach = PlanPoint.Dot(direction, a + (b - a) * (sideA / (sideA - sideB)));
                if (reach > 0.0 && reach < nearest)
                    (nearest, met) = (reach, k);
            }

            return nearest;
        }
    }
}
