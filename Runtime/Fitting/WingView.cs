using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Plan of a wing seen as a right wing's: x from the base outwards along the span, z towards the leading edge, the reach from the
    /// anchor on its base being 1. The fit is computed in this view, so that it does not depend on position, size and side of a wing.
    /// </summary>
    internal readonly struct WingView
    {
        private readonly PlanPoint m_Anchor;
        private readonly double m_Reach;

        /// <summary>Unit vector of the plane, outwards along the span.</summary>
        public readonly PlanPoint span;

        /// <summary>Unit vector of the plane at right angles, towards the leading edge.</summary>
        public readonly PlanPoint forward;

        public WingView(PlanPoint anchor, PlanPoint span, PlanPoint forward, double reach)
        {
            m_Anchor = anchor;
            m_Reach = reach;
            this.span = span;
            this.forward = forward;
        }

        public PlanPoint ToWing(PlanPoint p)
        {
            PlanPoint from = p - m_Anchor;
            return new PlanPoint(PlanPoint.Dot(from, span), PlanPoint.Dot(from, forward)) * (1.0 / m_Reach);
        }

        public PlanPoint FromWing(PlanPoint p) => m_Anchor + (span * p.x + forward * p.z) * m_Reach;

        /// <summary>
        /// Turns the outline into this view, from the place on it that is closest to the anchor, clockwise: along the leading edge to the
        /// tip and back along the trailing edge.
        /// </summary>
        public ClosedCurve Turn(ClosedCurve outline, double anchor)
        {
            int count = outline.Samples.Count;
            bool reverse = PlanPoint.Cross(span, forward) > 0.0;
            var turned = new List<PlanPoint>(count);
            for (int k = 0; k < count; k++)
                turned.Add(ToWing(outline.At(anchor + (reverse ? -k : k) * outline.Step)));
            return new ClosedCurve(turned, count);
        }

        /// <summary>The unit vector at right angles to v, towards the side of another.</summary>
        public static PlanPoint Across(PlanPoint v, PlanPoint side)
        {
            var across = new PlanPoint(-v.z, v.x);
            return PlanPoint.Dot(across, side) >= 0.0 ? across : across * -1.0;
        }
    }
}
