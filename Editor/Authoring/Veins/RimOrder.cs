using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>
    /// Order of places on an outline from the tip of the first chain towards that of the last one, round the tip of the wing and not its
    /// base.
    /// </summary>
    internal sealed class RimOrder
    {
        private readonly Polyline m_Rim;
        private readonly double m_Start;
        private readonly double m_Base;
        private readonly double m_Sign = 1.0;

        /// <param name="rim">The outline.</param>
        /// <param name="chains">From leading to trailing edge, each from root to tip.</param>
        public RimOrder(Polyline rim, IReadOnlyList<PlanPoint[]> chains)
        {
            m_Rim = rim;
            PlanPoint[] first = chains[0], last = chains[chains.Count - 1];
            m_Start = rim.Nearest(first[first.Length - 1]);
            double end = rim.Nearest(last[last.Length - 1]), root = rim.Nearest((first[0] + last[0]) * 0.5);
            if (Wrapped(end - m_Start) > Wrapped(root - m_Start))
                m_Sign = -1.0;
            m_Base = Wrapped(m_Sign * (root - m_Start));
        }

        /// <summary>Distance of a place of the outline behind the first chain's tip; negative ahead of it, on the leading edge.</summary>
        public double Of(double rimDistance)
        {
            double behind = Wrapped(m_Sign * (rimDistance - m_Start));
            return behind <= m_Base ? behind : behind - m_Rim.Length;
        }

        /// <summary>Order of the place on the rim closest to a point.</summary>
        public double Of(PlanPoint point) => Of(m_Rim.Nearest(point));

        private double Wrapped(double distance)
        {
            double rest = distance % m_Rim.Length;
            return rest < 0.0 ? rest + m_Rim.Length : rest;
        }
    }
}
