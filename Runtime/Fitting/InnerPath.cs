using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Shortest path inside a wing between two places of its outline: straight where possible, else past the notches of the trailing edge
    /// at a little distance.
    /// </summary>
    internal static class InnerPath
    {
        /// <summary>Number of places along the edge among which corners of the path are chosen.</summary>
        private const int k_Corners = 120;

        /// <summary>Distance of those corners inside the edge, wing reaches.</summary>
        private const double k_Clearance = 0.01;

        /// <summary>Steps in which a straight line is checked.</summary>
        private const double k_CheckStep = 0.005;

        /// <summary>Tolerated distance of a line outside the wing, as a line along a straight edge has by rounding, wing reaches.</summary>
        private const double k_Unminded = 0.003;

        /// <summary>The path from one place, backwards along the outline, to another.</summary>
        /// <param name="outline">Of the wing.</param>
        /// <param name="from">Arc length of its beginning, the larger one.</param>
        /// <param name="to">Arc length of its end.</param>
        public static List<PlanPoint> Find(ClosedCurve outline, double from, double to)
        {
            PlanPoint start = outline.At(from), end = outline.At(to);
            if (IsInside(outline, start, end))
                return new List<PlanPoint> { start, end };

            var corners = new List<PlanPoint> { start };
            for (int k = 1; k < k_Corners; k++)
            {
                double s = from + (to - from) * k / k_Corners;
                if (TryMoveInside(outline, s, out PlanPoint corner))
                    corners.Add(corner);
            }

            corners.Add(end);
            return Shortest(outline, corners);
        }

        // Whether all of a straight line lies inside or on the edge.
        private static bool IsInside(ClosedCurve outline, PlanPoint a, PlanPoint b)
        {
            double length = Math.Sqrt((b - a).LengthSquared);
            int steps = (int)Math.Ceiling(length / k_CheckStep);
            for (int k = 1; k < steps; k++)
            {
                PlanPoint p = a + (b - a) * ((double)k / steps);
                bool nearEnd = k * k_CheckStep < k_Clearance || (steps - k) * k_CheckStep < k_Clearance;
                if (!nearEnd && !outline.Contains(p) && !IsOnEdge(outline, p))
                    return false;
            }

            return true;
        }

        private static bool IsOnEdge(ClosedCurve outline, PlanPoint p) =>
            (outline.At(outline.Nearest(p)) - p).LengthSquared < k_Unminded * k_Unminded;

        // Clockwise round the wing, its inside lies to the right.
        private static bool TryMoveInside(ClosedCurve outline, double s, out PlanPoint moved)
        {
            var along = PlanPoint.Unit(outline.At(s + k_Clearance) - outline.At(s - k_Clearance));
            moved = outline.At(s) + new PlanPoint(along.z, -along.x) * k_Clearance;
            return outline.Contains(moved);
        }

        // Dijkstra's algorithm over lines of sight; where sight fails altogether, the next corner is always in sight. Of the ways to a
        // corner the shorter ones are looked along first: the first that is free is the way.
        private static List<PlanPoint> Shortest(ClosedCurve outline, List<PlanPoint> corners)
        {
            int count = corners.Count;
            double[] lengths = new double[count], ways = new double[count];
            int[] before = new int[count], order = new int[count];
            // Of two as long the earlier one, whatever the sort does.
            var shorter = Comparer<int>.Create((a, b) => ways[a] != ways[b] ? ways[a].CompareTo(ways[b]) : a.CompareTo(b));
            for (int k = 1; k < count; k++)
            {
                for (int earlier = 0; earlier < k; earlier++)
                {
                    order[earlier] = earlier;
                    ways[earlier] = lengths[earlier] + Math.Sqrt((corners[k] - corners[earlier]).LengthSquared);
                }

                Array.Sort(order, 0, k, shorter);
                int way = 0;
                while (order[way] != k - 1 && !IsInside(outline, corners[order[way]], corners[k]))
                    way++;
                before[k] = order[way];
                lengths[k] = ways[before[k]];
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
