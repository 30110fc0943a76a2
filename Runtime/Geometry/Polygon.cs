using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Closed polygons in plan, the last corner joined to the first.</summary>
    internal static class Polygon
    {
        /// <summary>Doubled area of a triangle, positive counterclockwise.</summary>
        public static double DoubledArea(PlanPoint a, PlanPoint b, PlanPoint c) => PlanPoint.Cross(b - a, c - a);

        /// <summary>Area of a polygon, positive counterclockwise.</summary>
        public static double Area(IReadOnlyList<PlanPoint> corners)
        {
            double doubled = 0.0;
            for (int k = 2; k < corners.Count; k++)
                doubled += DoubledArea(corners[0], corners[k - 1], corners[k]);
            return 0.5 * doubled;
        }

        /// <summary>Centre of its area.</summary>
        public static PlanPoint Centroid(IReadOnlyList<PlanPoint> corners)
        {
            var sum = new PlanPoint(0.0, 0.0);
            double doubled = 0.0;
            for (int k = 2; k < corners.Count; k++)
            {
                double area = DoubledArea(corners[0], corners[k - 1], corners[k]);
                doubled += area;
                sum += (corners[0] + corners[k - 1] + corners[k]) * (area / 3.0);
            }

            return doubled != 0.0 ? sum * (1.0 / doubled) : corners[0];
        }

        /// <summary>Returns true where a point lies inside: an odd number of edges lies beyond it.</summary>
        public static bool Contains(IReadOnlyList<PlanPoint> corners, PlanPoint p)
        {
            bool inside = false;
            PlanPoint before = corners[corners.Count - 1];
            for (int k = 0; k < corners.Count; k++)
            {
                PlanPoint corner = corners[k];
                if (corner.z > p.z != before.z > p.z
                    && p.x < corner.x + (before.x - corner.x) * (p.z - corner.z) / (before.z - corner.z))
                {
                    inside = !inside;
                }

                before = corner;
            }

            return inside;
        }

        /// <summary>Returns true where it runs counterclockwise and no two sides meet except neighbours at their ends.</summary>
        public static bool IsSimple(IReadOnlyList<PlanPoint> corners)
        {
            for (int a = 0; a < corners.Count; a++)
            {
                for (int b = a + 2; b < corners.Count; b++)
                {
                    int end = (b + 1) % corners.Count;
                    if (end != a && PlanPoint.SegmentsCross(corners[a], corners[a + 1], corners[b], corners[end]))
                        return false;
                }
            }

            return corners.Count > 2 && Area(corners) > 0.0;
        }

        /// <summary>Unit vector along which points spread most about a centre, from their second moments.</summary>
        public static PlanPoint LongestDirection(IEnumerable<PlanPoint> points, PlanPoint centre)
        {
            double xx = 0.0, xz = 0.0, zz = 0.0;
            foreach (PlanPoint point in points)
            {
                PlanPoint p = point - centre;
                xx += p.x * p.x;
                xz += p.x * p.z;
                zz += p.z * p.z;
            }

            double angle = 0.5 * Elementary.Atan2(2.0 * xz, xx - zz);
            return new PlanPoint(Elementary.Cos(angle), Elementary.Sin(angle));
        }

        /// <summary>Cosine of the angle by which it turns at a corner: 1 where it goes straight on.</summary>
        public static double TurnCosine(IReadOnlyList<PlanPoint> corners, int corner)
        {
            PlanPoint before = corners[corner] - corners[(corner + corners.Count - 1) % corners.Count];
            PlanPoint after = corners[(corner + 1) % corners.Count] - corners[corner];
            return PlanPoint.Dot(before, after) / Math.Sqrt(before.LengthSquared * after.LengthSquared);
        }

        /// <summary>
        /// Keeps some of the corners, so that no other lies further than a tolerance from the polygon through them (Douglas and Peucker,
        /// 1973).
        /// </summary>
        public static PlanPoint[] Simplified(PlanPoint[] corners, double tolerance)
        {
            int first = Farthest(corners, corners[0]), second = Farthest(corners, corners[first]);
            (first, second) = (Math.Min(first, second), Math.Max(first, second));
            bool[] kept = new bool[corners.Length];
            kept[first] = kept[second] = true;
            var open = new Stack<(int From, int To)>();
            open.Push((first, second));
            open.Push((second, first + corners.Length));
            while (open.Count > 0)
            {
                (int from, int to) = open.Pop();
                int worst = Worst(corners, from, to, tolerance);
                if (worst < 0)
                    continue;
                kept[worst % corners.Length] = true;
                open.Push((from, worst));
                open.Push((worst, to));
            }

            var simplified = new List<PlanPoint>();
            for (int k = 0; k < corners.Length; k++)
            {
                if (kept[k])
                    simplified.Add(corners[k]);
            }

            return simplified.ToArray();
        }

        /// <summary>Index of the corner farthest from a point.</summary>
        public static int Farthest(IReadOnlyList<PlanPoint> corners, PlanPoint from)
        {
            int farthest = 0;
            for (int k = 1; k < corners.Count; k++)
            {
                if ((corners[k] - from).LengthSquared > (corners[farthest] - from).LengthSquared)
                    farthest = k;
            }

            return farthest;
        }

        // Indices beyond the last one begin again.
        private static int Worst(PlanPoint[] corners, int from, int to, double tolerance)
        {
            int worst = -1;
            double most = tolerance * tolerance;
            for (int k = from + 1; k < to; k++)
            {
                double distance = PlanPoint.DistanceSquared(
                    corners[k % corners.Length], corners[from % corners.Length], corners[to % corners.Length]);
                if (distance > most)
                    (worst, most) = (k, distance);
            }

            return worst;
        }
    }
}
