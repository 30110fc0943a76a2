using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>A function on the rim of a polygon, straight between its corners.</summary>
    internal sealed class RimValues
    {
        private readonly IReadOnlyList<PlanPoint> m_Corners;
        private readonly IReadOnlyList<double> m_Values;

        public RimValues(IReadOnlyList<PlanPoint> corners, IReadOnlyList<double> values)
        {
            m_Corners = corners;
            m_Values = values;
        }

        /// <summary>Value at the rim's place closest to a point.</summary>
        public double Nearest(PlanPoint p)
        {
            double least = double.MaxValue, found = 0.0;
            for (int k = 0; k < m_Corners.Count; k++)
            {
                int next = k + 1 < m_Corners.Count ? k + 1 : 0;
                PlanPoint a = m_Corners[k], b = m_Corners[next];
                double share = PlanPoint.ClosestOnSegment(p, a, b);
                double distance = (a + (b - a) * share - p).LengthSquared;
                if (distance >= least)
                    continue;
                least = distance;
                found = m_Values[k] + (m_Values[next] - m_Values[k]) * share;
            }

            return found;
        }
    }
}
