using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>A closed line through points, the last of which is joined to the first.</summary>
    internal static class ClosedPath
    {
        /// <summary>The path with every point moved towards the middle of its neighbours, some times over (weights ¼, ½, ¼).</summary>
        public static PlanPoint[] Smoothed(IReadOnlyList<PlanPoint> path, int rounds)
        {
            int count = path.Count;
            var from = new PlanPoint[count];
            var to = new PlanPoint[count];
            for (int k = 0; k < count; k++)
                to[k] = path[k];
            for (int round = 0; round < rounds; round++)
            {
                (from, to) = (to, from);
                for (int k = 0; k < count; k++)
                    to[k] = from[k] * 0.5 + (from[(k + count - 1) % count] + from[(k + 1) % count]) * 0.25;
            }

            return to;
        }

        /// <summary>Some of the points, chosen so that no other lies further than a tolerance from the path through them (Douglas and Peucker, 1973).</summary>
        public static PlanPoint[] Simplified(PlanPoint[] path, double tolerance)
        {
            int first = Farthest(path, path[0]), second = Farthest(path, path[first]);
            (first, second) = (Math.Min(first, second), Math.Max(first, second));
            var kept = new bool[path.Length];
            kept[first] = kept[second] = true;
            var open = new Stack<(int From, int To)>();
            open.Push((first, second));
            open.Push((second, first + path.Length));
            while (open.Count > 0)
            {
                (int from, int to) = open.Pop();
                int worst = Worst(path, from, to, tolerance);
                if (worst < 0)
                    continue;
                kept[worst % path.Length] = true;
                open.Push((from, worst));
                open.Push((worst, to));
            }

            var simplified = new List<PlanPoint>();
            for (int k = 0; k < path.Length; k++)
            {
                if (kept[k])
                    simplified.Add(path[k]);
            }

            return simplified.ToArray();
        }

        /// <summary>Signed area; positive when the path runs from x to z, with the inside on its left.</summary>
        public static double Area(IReadOnlyList<PlanPoint> path)
        {
            double doubled = 0.0;
            for (int k = 0; k < path.Count; k++)
                doubled += PlanPoint.Cross(path[k] - path[0], path[(k + 1) % path.Count] - path[0]);
            return 0.5 * doubled;
        }

        /// <summary>Length all around.</summary>
        public static double Length(IReadOnlyList<PlanPoint> path)
        {
            double length = 0.0;
            for (int k = 0; k < path.Count; k++)
                length += Math.Sqrt((path[(k + 1) % path.Count] - path[k]).LengthSquared);
            return length;
        }

        /// <summary>Whether a point lies inside (even and odd crossings).</summary>
        public static bool Contains(IReadOnlyList<PlanPoint> path, PlanPoint point)
        {
            bool inside = false;
            for (int k = 0, before = path.Count - 1; k < path.Count; before = k++)
            {
                PlanPoint a = path[before], b = path[k];
                if (a.z > point.z != b.z > point.z && point.x < a.x + (point.z - a.z) / (b.z - a.z) * (b.x - a.x))
                    inside = !inside;
            }

            return inside;
        }

        /// <summary>Distance of a point from the path.</summary>
        public static double Distance(IReadOnlyList<PlanPoint> path, PlanPoint point)
        {
            double least = double.MaxValue;
            for (int k = 0, before = path.Count - 1; k < path.Count; before = k++)
                least = Math.Min(least, PlanPoint.DistanceSquared(point, path[before], path[k]));
            return Math.Sqrt(least);
        }

        /// <summary>The longer side of the path's bounds.</summary>
        public static double Extent(IReadOnlyList<PlanPoint> path)
        {
            double left = double.MaxValue, right = double.MinValue, low = double.MaxValue, high = double.MinValue;
            foreach (PlanPoint point in path)
            {
                left = Math.Min(left, point.x);
                right = Math.Max(right, point.x);
                low = Math.Min(low, point.z);
                high = Math.Max(high, point.z);
            }

            return Math.Max(right - left, high - low);
        }

        private static int Farthest(PlanPoint[] path, PlanPoint from)
        {
            int farthest = 0;
            for (int k = 1; k < path.Length; k++)
            {
                if ((path[k] - from).LengthSquared > (path[farthest] - from).LengthSquared)
                    farthest = k;
            }

            return farthest;
        }

        // Indices beyond the last one begin again.
        private static int Worst(PlanPoint[] path, int from, int to, double tolerance)
        {
            int worst = -1;
            double most = tolerance * tolerance;
            for (int k = from + 1; k < to; k++)
            {
                double distance = PlanPoint.DistanceSquared(path[k % path.Length], path[from % path.Length], path[to % path.Length]);
                if (distance > most)
                    (worst, most) = (k, distance);
            }

            return worst;
        }
    }
}
