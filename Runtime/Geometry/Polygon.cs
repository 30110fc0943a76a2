using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Closed polygons in plan, the last corner joined to the first.</summary>
    internal static class Polygon
    {
        /// <summary>Twice the area, positive counterclockwise.</summary>
        public static double DoubledArea(PlanPoint a, PlanPoint b, PlanPoint c) => PlanPoint.Cross(b - a, c - a);

        /// <summary>Positive counterclockwise.</summary>
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

        /// <summary>Whether an odd number of its edges lies beyond p.</summary>
        public static bool Contains(IReadOnlyList<PlanPoint> corners, PlanPoint p)
        {
            bool inside = false;
            PlanPoint before = corners[corners.Count - 1];
            for (int k = 0; k < corners.Count; k++)
            {
                PlanPoint corner = corners[k];
                if (corner.z > p.z != before.z > p.z
                    && p.x < corner.x + (before.x - corner.x) * (p.z - corner.z) / (before.z - corner.z))
                    inside = !inside;
                before = corner;
            }

            return inside;
        }
    }
}
