using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>A line through points with two ends.</summary>
    internal static class VeinPath
    {
        public static double Length(IReadOnlyList<PlanPoint> path)
        {
            double length = 0.0;
            for (int k = 0; k + 1 < path.Count; k++)
                length += Math.Sqrt((path[k + 1] - path[k]).LengthSquared);
            return length;
        }

        /// <summary>Places at even distances along the path, the ends among them.</summary>
        public static PlanPoint[] Resampled(IReadOnlyList<PlanPoint> path, int count)
        {
            var places = new PlanPoint[count];
            double length = Length(path), walked = 0.0;
            int segment = 0;
            for (int k = 0; k < count; k++)
            {
                double wanted = length * k / (count - 1), step = Step(path, segment);
                while (segment + 2 < path.Count && walked + step < wanted)
                {
                    walked += step;
                    step = Step(path, ++segment);
                }

                places[k] = path[segment] + (path[segment + 1] - path[segment]) * (step > 0.0 ? Math.Min(1.0, (wanted - walked) / step) : 0.0);
            }

            places[count - 1] = path[path.Count - 1];
            return places;
        }

        /// <summary>The path without its jitter: even steps, each moved to the middle of its surroundings; the ends stay.</summary>
        /// <param name="path">Two points or more.</param>
        /// <param name="reach">About how far the surroundings go; also the length of a step, at most.</param>
        public static PlanPoint[] Smoothed(IReadOnlyList<PlanPoint> path, double reach)
        {
            const int rounds = 4;
            PlanPoint[] to = Resampled(path, Math.Max(3, 1 + (int)Math.Ceiling(Length(path) / (0.7 * reach))));
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

        private static double Step(IReadOnlyList<PlanPoint> path, int segment) => Math.Sqrt((path[segment + 1] - path[segment]).LengthSquared);
    }
}
