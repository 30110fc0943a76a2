using System;
using Alate.Geometry;

namespace Alate
{
    /// <summary>One cell of the skeleton in plan: the quadrilateral of two neighbouring joints on two neighbouring chains.</summary>
    internal readonly struct BilinearCell
    {
        /// <summary>Tolerance for rounding of a coordinate outside [0, 1] that still counts as inside.</summary>
        private const double k_Rounding = 1e-9;

        private readonly PlanPoint m_P00;
        private readonly PlanPoint m_P01;
        private readonly PlanPoint m_P10;
        private readonly PlanPoint m_P11;
        private readonly PlanPoint m_Low;
        private readonly PlanPoint m_High;

        /// <summary>Makes a cell of four corners: the first index counts across the chains, the second along them.</summary>
        public BilinearCell(PlanPoint p00, PlanPoint p01, PlanPoint p10, PlanPoint p11)
        {
            m_P00 = p00;
            m_P01 = p01;
            m_P10 = p10;
            m_P11 = p11;
            m_Low = new PlanPoint(
                Math.Min(Math.Min(p00.x, p01.x), Math.Min(p10.x, p11.x)), Math.Min(Math.Min(p00.z, p01.z), Math.Min(p10.z, p11.z)));
            m_High = new PlanPoint(
                Math.Max(Math.Max(p00.x, p01.x), Math.Max(p10.x, p11.x)), Math.Max(Math.Max(p00.z, p01.z), Math.Max(p10.z, p11.z)));
        }

        /// <summary>Point of the cell with these coordinates.</summary>
        public PlanPoint At(double u, double v) =>
            (m_P00 * (1.0 - v) + m_P01 * v) * (1.0 - u) + (m_P10 * (1.0 - v) + m_P11 * v) * u;

        /// <summary>Lower bound for the squared distance of a point from the cell.</summary>
        public double LeastDistanceSquared(PlanPoint p)
        {
            double x = Math.Max(Math.Max(m_Low.x - p.x, p.x - m_High.x), 0.0), z = Math.Max(Math.Max(m_Low.z - p.z, p.z - m_High.z), 0.0);
            return x * x + z * z;
        }

        /// <summary>
        /// Finds the coordinates of p, and returns 0; for a point outside, those of the closest point on the outline of the cell, and
        /// returns its squared distance. Closest points keep the weights continuous from cell to cell outside the fan too, where
        /// coordinates clamped one by one do not.
        /// </summary>
        public double Locate(PlanPoint p, out double u, out double v)
        {
            if (TryInvert(p, out u, out v))
                return 0.0;
            double along = PlanPoint.ClosestOnSegment(p, m_P00, m_P01);
            double least = double.PositiveInfinity;
            Consider(p, m_P00, m_P01, along, 0.0, along, ref least, ref u, ref v);
            along = PlanPoint.ClosestOnSegment(p, m_P10, m_P11);
            Consider(p, m_P10, m_P11, along, 1.0, along, ref least, ref u, ref v);
            double across = PlanPoint.ClosestOnSegment(p, m_P00, m_P10);
            Consider(p, m_P00, m_P10, across, across, 0.0, ref least, ref u, ref v);
            across = PlanPoint.ClosestOnSegment(p, m_P01, m_P11);
            Consider(p, m_P01, m_P11, across, across, 1.0, ref least, ref u, ref v);
            return least;
        }

        private static void Consider(
            PlanPoint p, PlanPoint a, PlanPoint b, double share, double u, double v, ref double least, ref double bestU, ref double bestV)
        {
            double distance = (a + (b - a) * share - p).LengthSquared;
            if (distance >= least)
                return;
            least = distance;
            bestU = u;
            bestV = v;
        }

        /// <summary>
        /// Inverts p = p00 + u c + v b + u v d; returns true where both coordinates lie in [0, 1]. The cross product with (b + u d) leaves
        /// a quadratic in u, which is linear where the chains are parallel.
        /// </summary>
        public bool TryInvert(PlanPoint p, out double u, out double v)
        {
            PlanPoint r = p - m_P00, b = m_P01 - m_P00, c = m_P10 - m_P00, d = m_P11 - m_P10 - b;
            double square = -PlanPoint.Cross(c, d);
            double linear = PlanPoint.Cross(r, d) - PlanPoint.Cross(c, b);
            double constant = PlanPoint.Cross(r, b);
            double discriminant = linear * linear - 4.0 * square * constant;
            u = v = 0.0;
            if (discriminant < 0.0)
                return false;
            double half = -0.5 * (linear + (linear < 0.0 ? -Math.Sqrt(discriminant) : Math.Sqrt(discriminant)));
            return (half != 0.0 && TryRoot(constant / half, r, b, c, d, out u, out v))
                || (square != 0.0 && TryRoot(half / square, r, b, c, d, out u, out v));
        }

        private static bool TryRoot(double root, PlanPoint r, PlanPoint b, PlanPoint c, PlanPoint d, out double u, out double v)
        {
            u = root;
            v = 0.0;
            if (!(u >= -k_Rounding && u <= 1.0 + k_Rounding))
                return false;
            PlanPoint along = b + d * u;
            double length = along.LengthSquared;
            if (length <= 0.0)
                return false;
            v = PlanPoint.Dot(r - c * u, along) / length;
            if (!(v >= -k_Rounding && v <= 1.0 + k_Rounding))
                return false;
            u = Math.Min(Math.Max(u, 0.0), 1.0);
            v = Math.Min(Math.Max(v, 0.0), 1.0);
            return true;
        }
    }
}
