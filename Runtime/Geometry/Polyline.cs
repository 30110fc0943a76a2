using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Measures and resamples lines through points in plan, with two ends.</summary>
    internal static class Polyline
    {
        /// <summary>Length of a line.</summary>
        public static double Length(IReadOnlyList<PlanPoint> path)
        {
            double length = 0.0;
            for (int k = 1; k < path.Count; k++)
                length += Math.Sqrt((path[k] - path[k - 1]).LengthSquared);
            return length;
        }

        /// <summary>Points at even steps of a line's length, both ends included.</summary>
        /// <param name="path">At least two points.</param>
        /// <param name="count">At least 2.</param>
        public static PlanPoint[] Even(IReadOnlyList<PlanPoint> path, int count)
        {
            var points = new PlanPoint[count];
            double step = Length(path) / (count - 1), start = 0.0;
            int corner = 1;
            for (int k = 0; k < count - 1; k++)
            {
                double stretch = Math.Sqrt((path[corner] - path[corner - 1]).LengthSquared);
                while (start + stretch < k * step && corner + 1 < path.Count)
                {
                    start += stretch;
                    corner++;
                    stretch = Math.Sqrt((path[corner] - path[corner - 1]).LengthSquared);
                }

                double share = stretch > 0.0 ? Math.Min((k * step - start) / stretch, 1.0) : 0.0;
                points[k] = path[corner - 1] + (path[corner] - path[corner - 1]) * share;
            }

            points[count - 1] = path[path.Count - 1];
            return points;
        }

        /// <summary>Path smoothed in even steps, each point moved to the middle of its surroundings; the ends stay.</summary>
        /// <param name="path">Two points or more.</param>
        /// <param name="reach">About how far the surroundings go; also the length of a step, at most.</param>
        public static PlanPoint[] Smoothed(IReadOnlyList<PlanPoint> path, double reach)
        {
            const int rounds = 4;
            PlanPoint[] to = Even(path, Math.Max(3, 1 + (int)Math.Ceiling(Length(path) / (0.7 * reach))));
            for (int round = 0; round < rounds; round++)
            {
                var from = (PlanPoint[])to.Clone();
                for (int k = 1; k + 1 < to.Length; k++)
                    to[k] = from[k] * 0.5 + (from[k - 1] + from[k + 1]) * 0.25;
            }

            return to;
        }

        /// <summary>Distance of a point from the path.</summary>
        public static double Distance(IReadOnlyList<PlanPoint> path, PlanPoint point)
        {
            double least = double.MaxValue;
            for (int k = 0; k + 1 < path.Count; k++)
                least = Math.Min(least, PlanPoint.DistanceSquared(point, path[k], path[k + 1]));
            return Math.Sqrt(least);
        }
    }
}
