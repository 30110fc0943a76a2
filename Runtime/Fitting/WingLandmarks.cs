using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Places on a wing's outline between which its skeleton is laid: both ends of the base, the tip at the end of the leading edge, and
    /// the end of the last chain on the trailing edge. Arc lengths are those of the turned outline.
    /// </summary>
    internal sealed class WingLandmarks
    {
        /// <summary>Distance from the anchor along the span, wing reaches, up to which the outline counts as base.</summary>
        private const double k_BaseDepth = 0.005;

        /// <summary>Widest base.</summary>
        private const double k_BaseWidth = 0.35;

        /// <summary>
        /// The tip is where the outline touches the outermost of the spirals ln r + c·angle = const about the base: the farthest place,
        /// of nearly equally far ones one closer to the leading edge. This is c.
        /// </summary>
        private const double k_Spiral = 0.36;

        /// <summary>Standard deviation of the tip's place, wing reaches, up to which it is clear; a round wing has about 0.06.</summary>
        private const double k_ClearTip = 0.075;

        /// <summary>Sharpness with which the spirals' touch and the trailing edge's deepest place are taken.</summary>
        private const double k_TipSharpness = 250.0;
        private const double k_LastSharpness = 150.0;

        /// <summary>
        /// Depth that a place of the trailing edge must gain to lie a quarter of the edge away from its middle, around which the last tip
        /// is searched.
        /// </summary>
        private const double k_MiddlePull = 0.07;

        /// <summary>Largest reach of the last chain over that of the first; a longer one would count as the principal chain.</summary>
        private const double k_MostReach = 1.3;

        private readonly ClosedCurve m_Outline;

        /// <param name="outline">The turned outline.</param>
        /// <param name="notes">Takes the warning of an unclear tip.</param>
        public WingLandmarks(ClosedCurve outline, FitNotes notes)
        {
            m_Outline = outline;
            LeadingRoot = BaseEnd(1.0, outline.At(0.0), k_BaseWidth);
            double back = BaseEnd(-1.0, outline.At(LeadingRoot), k_BaseWidth);
            TrailingRoot = outline.Length + back;
            Base = (outline.At(LeadingRoot) + outline.At(TrailingRoot)) * 0.5;
            Trimmed = new TrimmedOutline(outline, LeadingRoot, TrailingRoot);
            Tip = FindTip(out double spread);
            Rays = FindRays();
            if (Rays.Count > 0)
            {
                Tip = Rays[0];
                Last = Rays[Rays.Count - 1];
                Trimmed.Restore(new OutlineStretch(Tip, Last));
                return;
            }

            Last = FindLast();
            if (spread > k_ClearTip)
            {
                notes.Warn(
                    SkeletonFitWarningKind.TipUnclear, k_ClearTip / spread,
                    "The wing has no clear tip; the leading edge ends somewhere within "
                    + $"{FitNotes.Percent(2.0 * spread)} of its length.");
            }
        }

        /// <summary>The outline without its tails.</summary>
        public TrimmedOutline Trimmed { get; }

        /// <summary>Arc lengths of the ends of a fan's rays, in order; empty on other wings.</summary>
        public IReadOnlyList<double> Rays { get; }

        /// <summary>Arc length at which the leading edge begins.</summary>
        public double LeadingRoot { get; }

        /// <summary>Arc length at which the leading edge ends: at the wing's tip, or at the first ray.</summary>
        public double Tip { get; }

        /// <summary>Returns true where a chain that ends at a point is short enough to be the last.</summary>
        public bool IsLastInReach(PlanPoint end) => IsInReach(end, m_Outline.At(Tip));

        /// <summary>Arc length at which the last chain ends.</summary>
        public double Last { get; }

        /// <summary>Arc length at which the trailing edge ends.</summary>
        public double TrailingRoot { get; }

        /// <summary>Middle of the base.</summary>
        public PlanPoint Base { get; }

        private bool IsInReach(PlanPoint end, PlanPoint tip) =>
            (end - Base).LengthSquared <= k_MostReach * k_MostReach * (tip - Base).LengthSquared;

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

        // On the trimmed outline; at the very end where that is a point; before its neck where it is a tail.
        private double FindTip(out double spread)
        {
            double tip = Outermost(LeadingRoot, TrailingRoot, Trimmed.At, out spread);
            if (Trimmed.TryFindTail(tip, out OutlineStretch point))
                tip = Outermost(point.from, point.to, m_Outline.At, out spread);
            if (!TipNeck.TryFind(m_Outline, LeadingRoot, tip, TrailingRoot, out OutlineStretch tail))
                return tip;
            Trimmed.Cut(tail);
            return Outermost(LeadingRoot, tail.from, Trimmed.At, out spread);
        }

        private double Outermost(double from, double to, Func<double, PlanPoint> place, out double spread)
        {
            int steps = m_Outline.Samples.Count;
            double angle = 0.0;
            double[] values = new double[steps + 1];
            PlanPoint before = place(from) - Base;
            for (int k = 0; k <= steps; k++)
            {
                PlanPoint at = place(from + (to - from) * k / steps) - Base;
                if (at.LengthSquared > 0.0 && before.LengthSquared > 0.0)
                    angle += Elementary.Atan2(PlanPoint.Cross(before, at), PlanPoint.Dot(before, at));
                before = at;
                values[k] = 0.5 * Elementary.Log(Math.Max(at.LengthSquared, 1e-12)) + k_Spiral * angle;
            }

            return SoftMaximum.Find(
                from, to, steps, k_TipSharpness, s => values[(int)Math.Round((s - from) / (to - from) * steps)], out spread);
        }

        // The most of them of which the last does not reach too far for the first: a fin may begin with short ones, or end with long ones.
        private List<double> FindRays()
        {
            List<double> rays = MarginRays.Find(m_Outline, LeadingRoot, TrailingRoot, Tip);
            int from = 0, count = 0;
            for (int first = 0; first < rays.Count; first++)
            {
                int last = rays.Count - 1;
                while (!IsInReach(m_Outline.At(rays[last]), m_Outline.At(rays[first])))
                    last--;
                if (last - first + 1 > count)
                    (from, count) = (first, last - first + 1);
            }

            return count < MarginRays.Least ? new List<double>() : rays.GetRange(from, count);
        }

        private double FindLast()
        {
            var axis = PlanPoint.Unit(Polygon.Centroid(m_Outline.Samples) - Base);
            PlanPoint rear = WingView.Across(axis, new PlanPoint(0.0, -1.0));
            List<PlanPoint> edge = Trimmed.Along(Tip, TrailingRoot);
            double[] walked = new double[edge.Count];
            for (int k = 1; k < edge.Count; k++)
                walked[k] = walked[k - 1] + Math.Sqrt((edge[k] - edge[k - 1]).LengthSquared);
            int end = edge.Count - 1;
            return Tip + (TrailingRoot - Tip) / end * SoftMaximum.Find(0.0, end, end, k_LastSharpness, Depth, out _);

            double Depth(double at)
            {
                int k = (int)Math.Round(at);
                if (!IsLastInReach(edge[k]))
                    return double.NegativeInfinity;
                double off = (walked[k] / walked[walked.Length - 1] - 0.5) / 0.25;
                return PlanPoint.Dot(edge[k], rear) - k_MiddlePull * off * off;
            }
        }
    }
}
