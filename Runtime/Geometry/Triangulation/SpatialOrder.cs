using System;

namespace Alate.Geometry
{
    /// <summary>Orders points so that neighbours in the order are neighbours in the plane: rows of a grid, there and back.</summary>
    internal static class SpatialOrder
    {
        /// <summary>The indices of the points in that order.</summary>
        public static int[] Of(PlanPoint[] points)
        {
            var bounds = new PlanBounds(points);
            double rows = Math.Max(1.0, Math.Sqrt(points.Length));
            int[] order = new int[points.Length];
            double[] keys = new double[points.Length];
            for (int k = 0; k < points.Length; k++)
            {
                order[k] = k;
                double row = Math.Floor((points[k].z - bounds.low) / bounds.Extent * rows),
                    along = (points[k].x - bounds.left) / bounds.Extent;
                keys[k] = row + 0.999 * (row % 2 == 0 ? along : 1.0 - along);
            }

            Array.Sort(keys, order);
            return order;
        }
    }
}
