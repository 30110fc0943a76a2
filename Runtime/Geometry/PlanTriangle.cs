using System;

namespace Alate.Geometry
{
    /// <summary>Triangle in plan, of either orientation.</summary>
    internal readonly struct PlanTriangle
    {
        private readonly PlanPoint m_A;
        private readonly PlanPoint m_B;
        private readonly PlanPoint m_C;

        public PlanTriangle(PlanPoint a, PlanPoint b, PlanPoint c)
        {
            m_A = a;
            m_B = b;
            m_C = c;
        }

        /// <summary>Lower bound for the squared distance of a point from the triangle.</summary>
        public double LeastDistanceSquared(PlanPoint p)
        {
            double x = Outside(p.x, m_A.x, m_B.x, m_C.x), z = Outside(p.z, m_A.z, m_B.z, m_C.z);
            return x * x + z * z;
        }

        /// <summary>Squared distance of p from it, and the weights of its corners at the point closest to p.</summary>
        public double Closest(PlanPoint p, out double a, out double b, out double c)
        {
            double whole = Polygon.DoubledArea(m_A, m_B, m_C);
            if (whole != 0.0)
            {
                a = Polygon.DoubledArea(p, m_B, m_C) / whole;
                b = Polygon.DoubledArea(m_A, p, m_C) / whole;
                c = 1.0 - a - b;
                if (a >= 0.0 && b >= 0.0 && c >= 0.0)
                    return 0.0;
            }

            double ab = PlanPoint.ClosestOnSegment(p, m_A, m_B), bc = PlanPoint.ClosestOnSegment(p, m_B, m_C);
            double ca = PlanPoint.ClosestOnSegment(p, m_C, m_A);
            double offAb = (m_A + (m_B - m_A) * ab - p).LengthSquared, offBc = (m_B + (m_C - m_B) * bc - p).LengthSquared;
            double offCa = (m_C + (m_A - m_C) * ca - p).LengthSquared;
            a = b = c = 0.0;
            if (offAb <= offBc && offAb <= offCa)
            {
                a = 1.0 - ab;
                b = ab;
                return offAb;
            }

            if (offBc <= offCa)
            {
                b = 1.0 - bc;
                c = bc;
                return offBc;
            }

            c = 1.0 - ca;
            a = ca;
            return offCa;
        }

        private static double Outside(double p, double a, double b, double c) =>
            Math.Max(Math.Max(Math.Min(Math.Min(a, b), c) - p, p - Math.Max(Math.Max(a, b), c)), 0.0);
    }
}
