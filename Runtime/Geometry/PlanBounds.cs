using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>The smallest upright rectangle around points in plan.</summary>
    internal readonly struct PlanBounds
    {
        public readonly double left, right, low, high;

        public PlanBounds(IReadOnlyList<PlanPoint> points)
        {
            left = low = double.MaxValue;
            right = high = double.MinValue;
            for (int k = 0; k < points.Count; k++)
            {
                left = Math.Min(left, points[k].x);
                right = Math.Max(right, points[k].x);
                low = Math.Min(low, points[k].z);
                high = Math.Max(high, points[k].z);
            }
        }

        /// <summary>The longer side.</summary>
        public double Extent => Math.Max(right - left, high - low);
    }
}
