using System;

namespace Alate
{
    /// <summary>
    /// The places on a wing's outline between which its skeleton is laid: both ends of the base, the tip at the end of the leading edge,
    /// and where the last chain ends on the trailing edge. Arc lengths on the turned outline.
    /// </summary>
    internal sealed class WingLandmarks
    {
        /// <summary>How far out from the anchor, along the span, the outline still is base.</summary>
        private const double k_BaseDepth = 0.005;

        /// <summary>Widest base.</summary>
        private const double k_BaseWidth = 0.35;

        /// <summary>
        /// The tip is where the outline touches the outermost of the spirals ln r + c·angle = const about the base: the farthest place,
        /// of nearly equally far ones one closer to the leading edge. This is c.
        /// </summary>
        private const double k_Spiral = 0.35;

        /// <summary>How sharp the spirals' touch and the trailing edge's deepest place are taken.</summary>
        private const double k_TipSharpness = 250.0;
        private const double k_LastSharpness = 150.0;

        /// <summary>The last tip is looked for around the middle of the trailing edge: depth that it must win to lie a quarter of the edge off.</summary>
        private const double k_MiddlePull = 0.05;

        private readonly ClosedCurve m_Outline;

        public WingLandmarks(ClosedCurve outline)
        {
            m_Outline = outline;
            LeadingRoot = BaseEnd(1.0, outline.At(0.0), k_BaseWidth);
            double back = BaseEnd(-1.0, outline.At(LeadingRoot), k_BaseWidth);
            TrailingRoot = outline.Length + back;
            Base = (outline.At(LeadingRoot) + outline.At(TrailingRoot)) * 0.5;
            Tip = FindTip(out double spread);
            TipSpread = spread;
            Last = FindLast();
        }

        /// <summary>Where the leading edge begins.</summary>
        public double LeadingRoot { get; }

        /// <summary>Where the leading edge ends.</summary>
        public double Tip { get; }

        /// <summary>How far, along the outline, the tip is unclear.</summary>
        public double TipSpread { get; }

        /// <summary>Where the last chain ends.</summary>
        public double Last { get; }

        /// <summary>Where the trailing edge ends.</summary>
        public double TrailingRoot { get; }

        /// <summary>The middle of the base.</summary>
        public PlanPoint Base { get; }

        // The first place from the anchor that lies too far out along the span or too far from another place.
        private double BaseEnd(double sign, PlanPoint other, double width)
        {
            double level = m_Outline.At(0.0).x + k_BaseDepth, step = 0.25 * m_Outline.Step;
            double s = 0.0;
            while (Math.Abs(s) < 0.5 * m_Outline.Length)
            {
                PlanPoint next = m_Outline.At(s + sign * step);
                if (next.x > level || (next - other).LengthSquared > width * width)
                    break;
                s += sign * step;
            }

            return s;
        }

        private double FindTip(out double spread)
        {
            int steps = m_Outline.Samples.Count;
            double from = LeadingRoot, to = TrailingRoot, angle = 0.0;
            var values = new double[steps + 1];
            PlanPoint before = m_Outline.At(from) - Base;
            for (int k = 0; k <= steps; k++)
            {
                PlanPoint at = m_Outline.At(from + (to - from) * k / steps) - Base;
                if (at.LengthSquared > 0.0 && before.LengthSquared > 0.0)
                    angle += Math.Atan2(PlanPoint.Cross(before, at), PlanPoint.Dot(before, at));
                before = at;
                values[k] = 0.5 * Math.Log(Math.Max(at.LengthSquared, 1e-12)) + k_Spiral * angle;
            }

            return SoftMaximum.Find(
                from, to, steps, k_TipSharpness, s => values[(int)Math.Round((s - from) / (to - from) * steps)], out spread);
        }

        private double FindLast()
        {
            PlanPoint axis = WingView.Unit(Polygon.Centroid(m_Outline.Samples) - Base);
            PlanPoint rear = WingView.Across(axis, new PlanPoint(0.0, -1.0));
            double from = Tip, to = TrailingRoot;
            return SoftMaximum.Find(from, to, m_Outline.Samples.Count, k_LastSharpness, s => Depth(s), out _);

            double Depth(double s)
            {
                double off = ((s - from) / (to - from) - 0.5) / 0.25;
                return PlanPoint.Dot(m_Outline.At(s), rear) - k_MiddlePull * off * off;
            }
        }
    }
}
