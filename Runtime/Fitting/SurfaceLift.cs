using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>Puts points of the plan onto the surface of a sheet; those beside it onto the closest place of its rim.</summary>
    internal sealed class SurfaceLift
    {
        private readonly WingSheet m_Sheet;

        public SurfaceLift(WingSheet sheet)
        {
            m_Sheet = sheet;
        }

        /// <summary>Place on the surface, in unit space.</summary>
        /// <param name="p">Seen from above.</param>
        public float3 Lift(PlanPoint p)
        {
            double least = double.MaxValue;
            float3 found = m_Sheet.plane.FromPlan(p, 0.0);
            for (int k = 0; k < m_Sheet.triangles.Count && least > 0.0; k++)
            {
                int3 t = m_Sheet.triangles[k];
                var triangle = new PlanTriangle(m_Sheet.plan[t.x], m_Sheet.plan[t.y], m_Sheet.plan[t.z]);
                if (triangle.LeastDistanceSquared(p) >= least)
                    continue;
                double distance = triangle.Closest(p, out double a, out double b, out double c);
                if (distance >= least)
                    continue;
                least = distance;
                found = (float)a * m_Sheet.points[t.x] + (float)b * m_Sheet.points[t.y] + (float)c * m_Sheet.points[t.z];
            }

            return found;
        }
    }
}
