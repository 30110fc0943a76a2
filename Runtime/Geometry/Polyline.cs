using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>A line through points in plan, with two ends or closed, walked by its length.</summary>
    internal sealed class Polyline
    {
        private readonly PlanPoint[] m_Points;
        private readonly double[] m_Lengths;

        /// <param name="points">Two or more.</param>
        /// <param name="isClosed">Whether the last is joined to the first.</param>
        public Polyline(PlanPoint[] points, bool isClosed = false)
        {
            m_Points = points;
            m_Lengths = new double[isClosed ? points.Length + 1 : points.Length];
            for (int k = 0; k + 1 < m_Lengths.Length; k++)
                m_Lengths[k + 1] = m_Lengths[k] + Math.Sqrt((this[k + 1] - points[k]).LengthSquared);
        }

        public IReadOnlyList<PlanPoint> Points => m_Points;

        /// <summary>Length from end to end, or all around.</summary>
        public double Length => m_Lengths[m_Lengths.Length - 1];

        /// <summary>A point; behind the last the first comes again.</summary>
        public PlanPoint this[int point] => m_Points[point < m_Points.Length ? point : point - m_Points.Length];

        /// <summary>Lines one after the other; a point where two meet is one point.</summary>
        public static Polyline Join(params Polyline[] parts)
        {
            var points = new List<PlanPoint>();
            foreach (Polyline part in parts)
            {
                foreach (PlanPoint point in part.m_Points)
                {
                    if (points.Count == 0 || points[points.Count - 1].x != point.x || points[points.Count - 1].z != point.z)
                        points.Add(point);
                }
            }

            return new Polyline(points.ToArray());
        }

        /// <summary>The line through a function's points at even steps from 0 to 1, both ends among them.</summary>
        public static Polyline Trace(int steps, Func<double, PlanPoint> at)
        {
            var points = new PlanPoint[steps + 1];
            for (int step = 0; step <= steps; step++)
                points[step] = at((double)step / steps);
            return new Polyline(points);
        }

        /// <summary>The line up to a distance.</summary>
        public Polyline Until(double distance)
        {
            var points = new List<PlanPoint>();
            for (int k = 0; k < m_Points.Length && m_Lengths[k] < distance; k++)
                points.Add(m_Points[k]);
            points.Add(At(distance));
            return new Polyline(points.ToArray());
        }

        /// <summary>Distance along the line of one of its points.</summary>
        public double DistanceTo(int point) => m_Lengths[point];

        /// <summary>The place at a distance along the line, from 0 to its length.</summary>
        public PlanPoint At(double distance)
        {
            int segment = SegmentAt(distance);
            double stretch = m_Lengths[segment + 1] - m_Lengths[segment];
            double share = stretch > 0.0 ? Math.Clamp((distance - m_Lengths[segment]) / stretch, 0.0, 1.0) : 0.0;
            return share < 1.0 ? Between(segment, share) : this[segment + 1];
        }

        /// <summary>Place on the segment behind a point, at a share of its length.</summary>
        public PlanPoint Between(int segment, double share)
        {
            PlanPoint from = this[segment];
            return from + (this[segment + 1] - from) * share;
        }

        /// <summary>The point before a distance along the line.</summary>
        public int SegmentAt(double distance)
        {
            int found = Array.BinarySearch(m_Lengths, distance);
            return Math.Clamp(found >= 0 ? found : ~found - 1, 0, m_Lengths.Length - 2);
        }

        /// <summary>Unit direction from a point to the next.</summary>
        public PlanPoint Direction(int segment)
        {
            PlanPoint along = this[segment + 1] - this[segment];
            return along * (1.0 / Math.Max(Math.Sqrt(along.LengthSquared), double.Epsilon));
        }

        /// <summary>Distance along the line of its place closest to a point.</summary>
        public double Nearest(PlanPoint point)
        {
            int segment = NearestSegment(point, out double share);
            return m_Lengths[segment] + share * (m_Lengths[segment + 1] - m_Lengths[segment]);
        }

        /// <summary>The segment closest to a point, the first of several, and the share of it at which its closest place lies.</summary>
        public int NearestSegment(PlanPoint point, out double share)
        {
            double least = double.MaxValue, distance = double.MaxValue;
            int nearest = 0;
            share = 0.0;
            for (int k = 0; k + 1 < m_Lengths.Length; k++)
            {
                // No place of a segment lies nearer than its beginning by more than its length.
                double reach = distance + (m_Lengths[k + 1] - m_Lengths[k]);
                if ((this[k] - point).LengthSquared >= reach * reach)
                    continue;
                double along = PlanPoint.ClosestOnSegment(point, this[k], this[k + 1]), square = (Between(k, along) - point).LengthSquared;
                if (square < least)
                    (nearest, share, least, distance) = (k, along, square, Math.Sqrt(square));
            }

            return nearest;
        }

        /// <summary>
        /// Distance along a ray to where it first meets the line, leaving out one segment; <see cref="double.MaxValue"/> when it never
        /// does.
        /// </summary>
        /// <param name="from">Where it begins.</param>
        /// <param name="direction">A unit vector.</param>
        /// <param name="skipped">The segment on which the ray begins, or −1.</param>
        /// <param name="met">The segment it meets.</param>
        public double RayDistance(PlanPoint from, PlanPoint direction, int skipped, out int met)
        {
            double nearest = double.MaxValue;
            met = -1;
            for (int k = 0; k + 1 < m_Lengths.Length; k++)
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

        /// <summary>Length of a path, from end to end or all around.</summary>
        public static double LengthOf(IReadOnlyList<PlanPoint> path, bool isClosed = false)
        {
            double length = 0.0;
            for (int k = 1; k < path.Count; k++)
                length += Math.Sqrt((path[k] - path[k - 1]).LengthSquared);
            return isClosed ? length + Math.Sqrt((path[0] - path[path.Count - 1]).LengthSquared) : length;
        }

        /// <summary>
        /// Points at even steps of a path's length: both ends of an open one among them, the first point of a closed one first.
        /// </summary>
        /// <param name="path">At least two points.</param>
        /// <param name="count">At least 2.</param>
        /// <param name="isClosed">Whether the last point is joined to the first.</param>
        public static PlanPoint[] Even(IReadOnlyList<PlanPoint> path, int count, bool isClosed = false)
        {
            var points = new PlanPoint[count];
            double step = LengthOf(path, isClosed) / (isClosed ? count : count - 1), start = 0.0;
            int corner = 0, last = isClosed ? path.Count - 1 : path.Count - 2;
            for (int k = 0; k < count; k++)
            {
                double stretch = Math.Sqrt((Next() - path[corner]).LengthSquared);
                while (start + stretch < k * step && corner < last)
                {
                    start += stretch;
                    corner++;
                    stretch = Math.Sqrt((Next() - path[corner]).LengthSquared);
                }

                double share = stretch > 0.0 ? Math.Min((k * step - start) / stretch, 1.0) : 0.0;
                points[k] = path[corner] + (Next() - path[corner]) * share;
            }

            if (!isClosed)
                points[count - 1] = path[path.Count - 1];
            return points;

            PlanPoint Next() => path[(corner + 1) % path.Count];
        }

        /// <summary>
        /// Path whose points are moved towards the middle of their neighbours four times (weights ¼, ½, ¼); the ends of an open one stay.
        /// </summary>
        public static PlanPoint[] Smoothed(IReadOnlyList<PlanPoint> path, bool isClosed = false)
        {
            const int rounds = 4;
            int count = path.Count, free = isClosed ? 0 : 1;
            var to = new PlanPoint[count];
            for (int k = 0; k < count; k++)
                to[k] = path[k];
            for (int round = 0; round < rounds; round++)
            {
                var from = (PlanPoint[])to.Clone();
                for (int k = free; k < count - free; k++)
                    to[k] = from[k] * 0.5 + (from[(k + count - 1) % count] + from[(k + 1) % count]) * 0.25;
            }

            return to;
        }

        /// <summary>Distance of a point from a path, open or closed.</summary>
        public static double Distance(IReadOnlyList<PlanPoint> path, PlanPoint point, bool isClosed = false)
        {
            double least = isClosed ? PlanPoint.DistanceSquared(point, path[path.Count - 1], path[0]) : double.MaxValue;
            for (int k = 0; k + 1 < path.Count; k++)
                least = Math.Min(least, PlanPoint.DistanceSquared(point, path[k], path[k + 1]));
            return Math.Sqrt(least);
        }
    }
}
