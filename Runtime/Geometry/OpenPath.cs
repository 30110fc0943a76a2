using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Polylines in plan.</summary>
    internal static class OpenPath
    {
        /// <summary>The length.</summary>
        public static double Length(IReadOnlyList<PlanPoint> path)
        {
            double length = 0.0;
            for (int k = 1; k < path.Count; k++)
                length += Math.Sqrt((path[k] - path[k - 1]).LengthSquared);
            return length;
        }

        /// <summary>Points at even steps of its length, both ends among them.</summary>
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
    }
}
