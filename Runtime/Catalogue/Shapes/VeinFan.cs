using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Catalogue
{
    /// <summary>
    /// Veins of a wing or rays of a fin: curves from the base to the margin, their forks, and cross veins between neighbours. They are laid
    /// out by shares of the margin, so that they fit whatever outline they are drawn into.
    /// </summary>
    internal sealed class VeinFan
    {
        private const int k_Steps = 20;
        private const double k_LadderStart = 0.15, k_LadderSlant = 0.35;

        private readonly WingOutline m_Outline;
        private readonly Polyline m_Margin;
        private readonly double m_Gather;
        private readonly List<(PlanPoint Root, PlanPoint Bend, PlanPoint Tip)> m_Veins =
            new List<(PlanPoint Root, PlanPoint Bend, PlanPoint Tip)>();
        private readonly StrokeSet m_Strokes = new StrokeSet();
        private readonly StrokeSet m_Crosses = new StrokeSet();

        /// <param name="outline">The outline to draw into.</param>
        /// <param name="gather">How closely veins follow the leading edge before they turn to their tips: 0 runs straight, 1 along the
        /// edge.</param>
        public VeinFan(WingOutline outline, double gather)
        {
            m_Outline = outline;
            m_Margin = WingRim.Margin(outline);
            m_Gather = gather;
        }

        /// <summary>Adds veins from leading to trailing edge, their roots even on the base, their tips at shares of the margin.</summary>
        public VeinFan Add(params double[] tips)
        {
            for (int k = 0; k < tips.Length; k++)
            {
                double across = (k + 0.5) / tips.Length;
                var root = new PlanPoint(0, m_Outline.LeadingAt(0) - across * m_Outline.ChordAt(0));
                PlanPoint tip = OnMargin(tips[k]);
                double span = 0.5 * tip.x;
                double straight = 0.5 * (root.z + tip.z);
                var bend = new PlanPoint(span, straight + m_Gather * (m_Outline.LeadingAt(span) - straight));
                m_Veins.Add((root, bend, tip));
                m_Strokes.Add(Curve(root, bend, tip));
            }

            return this;
        }

        /// <summary>Adds a branch: it leaves a vein at a share of its length for a share of the margin.</summary>
        public VeinFan Fork(int vein, double at, double tip)
        {
            PlanPoint from = On(vein, at);
            PlanPoint ahead = On(vein, Math.Min(1, at + 0.2));
            m_Strokes.Add(Curve(from, ahead, OnMargin(tip)), at);
            return this;
        }

        /// <summary>Adds cross veins from a vein to the next one, at shares of its length; none beyond the tip of that.</summary>
        public VeinFan Cross(int vein, params double[] at)
        {
            foreach (double share in at)
            {
                PlanPoint from = On(vein, share);
                // Beyond the tip of the next vein there is none to cross to.
                PlanPoint to = Nearest(vein + 1, from, out bool isTip);
                if (!isTip)
                    m_Crosses.Add(new[] { from.x, from.z, to.x, to.z });
            }

            return this;
        }

        /// <summary>Adds cross veins from the first vein to the leading edge, at a slant, as far as to where that vein meets it.</summary>
        /// <param name="count">Their number.</param>
        public VeinFan Ladder(int count)
        {
            for (int k = 0; k < count; k++)
            {
                PlanPoint from = On(0, k_LadderStart + (1 - k_LadderStart) * k / count);
                double span = Math.Min(1, from.x + k_LadderSlant * (m_Outline.LeadingAt(from.x) - from.z));
                m_Crosses.Add(new[] { from.x, from.z, span, m_Outline.LeadingAt(span) });
            }

            return this;
        }

        /// <summary>Adds a curve of its own through points, wing lengths.</summary>
        /// <param name="points">x, z, x, z, …</param>
        public VeinFan Curve(params double[] points)
        {
            m_Strokes.Add(Ink.Smooth(points));
            return this;
        }

        /// <summary>Place of a vein ahead of the hinge line at a span.</summary>
        /// <param name="vein">Its number.</param>
        /// <param name="span">Wing lengths; beyond its ends their places.</param>
        public double ForwardOf(int vein, double span)
        {
            double low = 0, high = 1;
            for (int halving = 0; halving < 30; halving++)
            {
                double middle = 0.5 * (low + high);
                if (On(vein, middle).x < span)
                    low = middle;
                else
                    high = middle;
            }

            return On(vein, low).z;
        }

        /// <summary>Distance to the nearest vein, with the share along it; a huge number where none is within reach.</summary>
        public double Distance(double span, double forward, out double along, double reach = double.MaxValue) =>
            m_Strokes.Distance(span, forward, out along, reach);

        /// <summary>Veins as soft lines of a half width.</summary>
        public float Veins(double span, double forward, double halfWidth, double softness) =>
            m_Strokes.Line(span, forward, halfWidth, softness);

        /// <summary>Cross veins as soft lines of a half width.</summary>
        public float CrossVeins(double span, double forward, double halfWidth, double softness) =>
            m_Crosses.Line(span, forward, halfWidth, softness);

        private PlanPoint On(int vein, double t)
        {
            (PlanPoint root, PlanPoint bend, PlanPoint tip) = m_Veins[vein];
            return At(root, bend, tip, t);
        }

        private PlanPoint Nearest(int vein, PlanPoint point, out bool isTip)
        {
            const int samples = 64;
            PlanPoint nearest = On(vein, 0);
            isTip = false;
            for (int k = 1; k <= samples; k++)
            {
                PlanPoint candidate = On(vein, (double)k / samples);
                if ((candidate - point).LengthSquared >= (nearest - point).LengthSquared)
                    continue;
                nearest = candidate;
                isTip = k == samples;
            }

            return nearest;
        }

        private PlanPoint OnMargin(double share) => m_Margin.At(m_Margin.Length * share);

        private static double[] Curve(PlanPoint root, PlanPoint bend, PlanPoint tip)
        {
            double[] points = new double[2 * (k_Steps + 1)];
            for (int step = 0; step <= k_Steps; step++)
            {
                PlanPoint point = At(root, bend, tip, (double)step / k_Steps);
                points[2 * step] = point.x;
                points[2 * step + 1] = point.z;
            }

            return points;
        }

        private static PlanPoint At(PlanPoint root, PlanPoint bend, PlanPoint tip, double t) =>
            root * ((1 - t) * (1 - t)) + bend * (2 * t * (1 - t)) + tip * (t * t);
    }
}
