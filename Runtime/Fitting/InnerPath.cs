using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Shortest path inside a wing between two places of its outline: straight where possible, else past the notches of the trailing edge
    /// at a little distance.
    /// </summary>
    internal sealed class InnerPath
    {
        /// <summary>Number of places along the edge among which corners of the path are chosen.</summary>
        private const int k_Corners = 120;

        /// <summary>Distance of those corners inside the edge, wing reaches.</summary>
        private const double k_Clearance = 0.01;

        /// <summary>Steps in which a straight line is checked.</summary>
        private const double k_CheckStep = 0.005;

        /// <summary>Tolerated distance of a line outside the wing, as a line along a straight edge has by rounding, wing reaches.</summary>
        private const double k_Unminded = 0.003;

        private readonly ClosedCurve m_Outline;

        public InnerPath(ClosedCurve outline)
        {
            m_Outline = outline;
        }

        /// <summary>The path from one place, backwards along the outline, to another.</summary>
        /// <param name="from">Arc length of its beginning, the larger one.</param>
        /// <param name="to">Arc length of its end.</param>
        public List<PlanPoint> Find(double from, double to)
        {
            PlanPoint start = m_Outline.At(from), end = m_Outline.At(to);
            if (IsInside(start, end))
                return new List<PlanPoint> { start, end };

            var corners = new List<PlanPoint> { start };
            for (int k = 1; k < k_Corners; k++)
            {
                double s = from + (to - from) * k / k_Corners;
                if (TryMoveInside(s, out PlanPoint corner))
                    corners.Add(corner);
            }

            corners.Add(end);
            return Shortest(corners);
        }

        /// <summary>Returns true where all of a straight line lies inside or on the edge.</summary>
        public bool IsInside(PlanPoint a, PlanPoint b)
        {
            double length = Math.Sqrt((b - a).LengthSquared);
            int steps = (int)Math.Ceiling(length / k_CheckStep);
            for (int k = 1; k < steps; k++)
            {
                PlanPoint p = a + (b - a) * ((double)k / steps);
                bool nearEnd = k * k_CheckStep < k_Clearance || (steps - k) * k_CheckStep < k_Clearance;
                if (!nearEnd && !m_Outline.Contains(p) && !IsOnEdge(p))
                    return false;
            }

            return true;
        }

        private bool IsOnEdge(PlanPoint p) => (m_Outline.At(m_Outline.Nearest(p)) - p).LengthSquared < k_Unminded * k_Unminded;

        // Clockwise round the wing, its inside lies to the right.
        private bool TryMoveInside(double s, out PlanPoint moved)
        {
            PlanPoint along = WingView.Unit(m_Outline.At(s + k_Clearance) - m_Outline.At(s - k_Clearance));
            moved = m_Outline.At(s) + new PlanPoint(along.z, -along.x) * k_Clearance;
            return m_Outline.Contains(moved);
        }

        // Dijkstra's algorithm over lines of sight; where sight fails altogether, the next corner is always in sight.
        private List<PlanPoint> Shortest(List<PlanPoint> corners)
        {
            int count = corners.Count;
            var lengths = new double[count];
            var before = new int[count];
            for (int k = 1; k < count; k++)
            {
                lengths[k] = double.MaxValue;
                for (int earlier = 0; earlier < k; earlier++)
                {
                    double length = lengths[earlier] + Math.Sqrt((corners[k] - corners[earlier]).LengthSquared);
                    if (length < lengths[k] && (earlier == k - 1 || IsInside(corners[earlier], corners[k])))
                    {
                        lengths[k] = length;
                        before[k] = earlier;
                    }
                }
            }

            var path = new List<PlanPoint>();
            for (int k = count - 1; k > 0; k = before[k])
                path.Add(corners[k]);
            path.Add(corners[0]);
            path.Reverse();
            return path;
        }
    }
}
