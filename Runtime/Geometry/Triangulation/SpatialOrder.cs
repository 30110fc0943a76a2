using System;

namespace Alate.Geometry
{
    /// <summary>Orders points so that neighbours in the order are neighbours in the plane: rows of a grid, there and back.</summary>
    internal static class SpatialOrder
    {
        /// <summary>The indices of the points in that order.</summary>
        public static int[] Of(PlanPoint[] points)
        {
            double left = double.MaxValue, right = double.MinValue, low = double.MaxValue, high = double.MinValue;
            foreach (PlanPoint point in points)
            {
                left = Math.Min(left, point.x);
                right = Math.Max(right, point.x);
                low = Math.Min(low, point.z);
                high = Math.Max(high, point.z);
            }

            double size = Math.Max(right - left, high - low);
            double rows = Math.Max(1.0, Math.Sqrt(points.Length));
            var order = new int[points.Length];
            var keys = new double[points.Length];
            for (int k = 0; k < points.Length; k++)
            {
                order[k] = k;
                double row = Math.Floor((points[k].z - low) / size * rows), along = (points[k].x - left) / size;
                keys[k] = row + 0.999 * (row % 2 == 0 ? along : 1.0 - along);
            }

            Array.Sort(keys, order);
            return order;
        }
    }
}
