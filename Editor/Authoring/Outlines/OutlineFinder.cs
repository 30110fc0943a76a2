using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Finds the outline of the wing in a picture.</summary>
    internal static class OutlineFinder
    {
        /// <summary>
        /// Furthest that a point of the rim may lie from the outline: a share of the wing's length, but no less than a part of a pixel.
        /// </summary>
        private const double k_Tolerance = 5e-4, k_LeastTolerance = 0.25;

        /// <summary>
        /// Finds the outline, counterclockwise with x to the right and z up: z is minus the row. Pixels of the whole picture.
        /// </summary>
        public static PlanPoint[] Find(WingSeparation wing, int factor)
        {
            List<PlanPoint> rim = ContourTracer.Longest(wing.SignedField());
            rim.Reverse();
            // Removes steps of single pixels and noise from the rim: a bell of one pixel.
            PlanPoint[] smooth = Polyline.Smoothed(rim.ConvertAll(p => new PlanPoint(p.x * factor, -p.z * factor)), true);
            return Polygon.Simplified(smooth, Math.Max(k_LeastTolerance * factor, k_Tolerance * new PlanBounds(smooth).Extent));
        }
    }
}
