using System;
using System.Collections.Generic;

namespace Alate.Geometry
{
    /// <summary>Checks that a closed line can be the rim of a mesh.</summary>
    internal static class RimCheck
    {
        /// <summary>Returns true where no two segments meet except neighbours at their ends.</summary>
        public static bool IsSimple(List<PlanPoint> rim)
        {
            for (int a = 0; a < rim.Count; a++)
            {
                for (int b = a + 2; b < rim.Count; b++)
                {
                    if ((b + 1) % rim.Count != a && Cross(rim[a], rim[a + 1], rim[b], rim[(b + 1) % rim.Count]))
                        return false;
                }
            }

            return rim.Count > 2 && Polygon.Area(rim) > 0.0;
        }

        private static bool Cross(PlanPoint a, PlanPoint b, PlanPoint c, PlanPoint d)
        {
            if (Math.Max(a.x, b.x) < Math.Min(c.x, d.x) || Math.Max(c.x, d.x) < Math.Min(a.x, b.x)
                || Math.Max(a.z, b.z) < Math.Min(c.z, d.z) || Math.Max(c.z, d.z) < Math.Min(a.z, b.z))
            {
                return false;
            }

            return PlanPoint.Cross(b - a, c - a) > 0.0 != PlanPoint.Cross(b - a, d - a) > 0.0
                && PlanPoint.Cross(d - c, a - c) > 0.0 != PlanPoint.Cross(d - c, b - c) > 0.0;
        }
    }
}
