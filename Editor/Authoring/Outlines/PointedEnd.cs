using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>
    /// Guesses the hinge of a wing from its outline alone: of the two ends of its longest direction, the one that is more pointed and from
    /// which more of the wing is visible; wings fan out from their hinges, and from the end of a tail little is visible. A triangle, as
    /// fore wings of butterflies are, is as pointed at its apex: there, the hinge is the end opposite the outer margin, its shortest side.
    /// </summary>
    internal static class PointedEnd
    {
        /// <summary>Confidence that the end is the hinge: where both ends are alike, and where one is far more pointed.</summary>
        private const double k_EvenConfidence = 0.5, k_PointedConfidence = 0.95;

        /// <summary>
        /// Difference of the ends, over the larger, from which one counts as far more pointed; below it a triangle's sides decide.
        /// </summary>
        private const double k_ClearDifference = 0.33;

        /// <summary>
        /// Least share of a wing's area in the triangle of both ends and the place farthest off the line between them, from which the wing
        /// counts as a triangle; and least distance of that place from the middle of the line, as a share of its length.
        /// </summary>
        private const double k_TriangleShare = 0.575, k_OffMiddle = 0.01;

        /// <summary>Confidence in the end opposite the shortest side.</summary>
        private const double k_TriangleConfidence = 0.85;

        /// <summary>Number of rays cast from an end, and radius of the room around it, as a share of the outline's extent.</summary>
        private const int k_Rays = 720;
        private const double k_Reach = 0.25;

        /// <summary>Power of the visible share of the wing by which the room around an end is divided.</summary>
        private const double k_SeenPower = 3.0;

        /// <summary>Least visible share: from the point of a needle nothing is visible.</summary>
        private const double k_LeastSeen = 0.05;

        /// <summary>Place of the end on the outline, and confidence that this end is the hinge, 0 to 1.</summary>
        public static (PlanPoint Place, double Confidence) Of(PlanPoint[] outline)
        {
            PlanPoint along = Longest(outline);
            PlanPoint first = outline[0], last = outline[0];
            foreach (PlanPoint point in outline)
            {
                first = PlanPoint.Dot(point, along) < PlanPoint.Dot(first, along) ? point : first;
                last = PlanPoint.Dot(point, along) > PlanPoint.Dot(last, along) ? point : last;
            }

            var rim = new Polyline(outline, true);
            double room = Room(rim, first, along), other = Room(rim, last, along * -1.0);
            double difference = Math.Abs(room - other) / Math.Max(room, other);
            if (difference < k_ClearDifference && OppositeShortest(outline, first, last) is PlanPoint hinge)
                return (hinge, k_TriangleConfidence);
            double clear = Math.Min(1.0, difference / k_ClearDifference);
            return (room <= other ? first : last, k_EvenConfidence + (k_PointedConfidence - k_EvenConfidence) * clear);
        }

        // Of both ends of a triangle the one farther from its third corner; null for other wings.
        private static PlanPoint? OppositeShortest(PlanPoint[] outline, PlanPoint first, PlanPoint last)
        {
            PlanPoint line = last - first, corner = first;
            double farthest = 0.0;
            foreach (PlanPoint point in outline)
            {
                double off = Math.Abs(PlanPoint.Cross(line, point - first));
                if (off > farthest)
                {
                    farthest = off;
                    corner = point;
                }
            }

            double along = PlanPoint.Dot(corner - first, line) / line.LengthSquared - 0.5;
            bool isTriangle = 0.5 * farthest >= k_TriangleShare * Polygon.Area(outline);
            return isTriangle && Math.Abs(along) > k_OffMiddle ? along > 0.0 ? first : last : (PlanPoint?)null;
        }

        // The area within a circle about an end, the larger the less of the whole wing is seen.
        private static double Room(Polyline rim, PlanPoint end, PlanPoint inward)
        {
            double reach = k_Reach * new PlanBounds(rim.Points).Extent, near = 0.0, all = 0.0;
            PlanPoint from = end + inward * (1e-3 * reach);

            // At a corner beside the wing's middle line the way along it leaves the wing.
            if (!Polygon.Contains(rim.Points, from))
                from = end + PlanPoint.Unit(Polygon.Centroid(rim.Points) - end) * (1e-3 * reach);
            for (int k = 0; k < k_Rays; k++)
            {
                double angle = 2.0 * Math.PI * k / k_Rays,
                    seen = rim.RayDistance(from, new PlanPoint(Math.Cos(angle), Math.Sin(angle)), -1, out int met);
                if (met < 0)
                    continue;
                near += Math.Min(reach * reach, seen * seen);
                all += seen * seen;
            }

            double share = all * Math.PI / k_Rays / Polygon.Area(rim.Points);
            return near / Math.Pow(Math.Min(1.0, Math.Max(k_LeastSeen, share)), k_SeenPower);
        }

        // From the second moments of evenly spread places on the outline.
        private static PlanPoint Longest(PlanPoint[] outline)
        {
            const int places = 400;
            var rim = new Polyline(outline, true);
            var even = new List<PlanPoint>();
            PlanPoint centre = default;
            for (int k = 0; k < places; k++)
            {
                even.Add(rim.At(rim.Length * k / places));
                centre += even[k] * (1.0 / places);
            }

            return Polygon.LongestDirection(even, centre);
        }
    }
}
