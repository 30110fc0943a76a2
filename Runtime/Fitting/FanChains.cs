using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Lays the chains of a wing: the first along its leading edge, the last straight to the trailing edge, those between along level
    /// lines of a <see cref="FanField"/>, straightened as far as the wing allows. A chain that ends next to a tail goes on into it.
    /// </summary>
    internal sealed class FanChains
    {
        /// <summary>Largest distance of a chain outside the wing without a warning, wing reaches.</summary>
        private const double k_Outside = 0.01;

        /// <summary>
        /// Share of the way by which a chain is drawn from its level line to a straight line; chains laid by hand are straight.
        /// </summary>
        private const double k_Straightness = 0.55;

        /// <summary>
        /// Largest distance of any straightened chain outside the wing before all chains keep to their level lines, wing reaches.
        /// </summary>
        private const double k_Stray = 0.03;

        private const int k_Places = 60;

        private readonly ClosedCurve m_Outline;
        private readonly WingLandmarks m_Marks;
        private readonly WingMargin m_Margin;
        private readonly FitNotes m_Notes;

        public FanChains(ClosedCurve outline, WingLandmarks marks, FitNotes notes)
        {
            m_Outline = outline;
            m_Marks = marks;
            m_Margin = new WingMargin(marks);
            m_Notes = notes;
        }

        /// <summary>
        /// [layout][chain][joint] Layouts in the wing's view, the best first; more than one where chains with evenly spaced joints meet.
        /// </summary>
        public List<PlanPoint[][]> Lay(int chains, int joints)
        {
            var shares = new FanShares(m_Marks, m_Margin, chains);
            var made = new PlanPoint[chains][];
            made[0] = BalancedJoints.Place(LeadingEdge(), joints);
            ChainInset.Apply(made[0], m_Outline);
            int last = chains - 1;
            List<PlanPoint> lastPath = InnerPath.Find(m_Outline, m_Marks.TrailingRoot, m_Marks.Last);
            made[last] = Jointed(new List<PlanPoint>(lastPath), shares.TailOf(last), joints);

            FanField field = Field(made[0], shares.TailOf(last) == null ? made[last] : (IReadOnlyList<PlanPoint>)lastPath);
            var levels = new List<PlanPoint>[chains];
            double straightness = k_Straightness;
            for (int i = 1; i < last; i++)
            {
                PlanPoint root = made[0][0] + (made[last][0] - made[0][0]) * shares[i], tip = m_Margin.At(shares[i]);
                levels[i] = LevelLine.Trace(field, shares[i], root, tip);
                double outside = ChainInset.Outside(new[] { root, tip }, m_Outline);
                straightness = Math.Min(straightness, k_Straightness * Math.Max(0.0, 1.0 - outside / k_Stray));
            }

            for (int i = 1; i < last; i++)
                made[i] = Jointed(Straightened(levels[i], straightness), shares.TailOf(i), joints);

            var layouts = new List<PlanPoint[][]>();
            if (ChainOrder.Cross(made))
            {
                levels[last] = lastPath;
                PlanPoint[][] bent = Bent(made, levels, joints);
                if (!ChainOrder.Cross(bent))
                    layouts.Add(bent);
                ChainOrder.Untangle(made);
            }

            layouts.Add(made);
            return layouts;
        }

        /// <summary>Warns about chains that leave the wing.</summary>
        public void Warn(PlanPoint[][] chains)
        {
            for (int i = 0; i < chains.Length; i++)
            {
                double outside = ChainInset.Outside(chains[i], m_Outline);
                if (outside > k_Outside)
                {
                    m_Notes.Warn(
                        SkeletonFitWarningKind.ChainLeavesWing, 0.9,
                        $"Chain {i} strays {FitNotes.Percent(outside, "0.#")} of the wing's length from it.");
                }
            }
        }

        // On a stalk chains lie side by side up to its end: as their level lines do, with joints where these bend.
        private static PlanPoint[][] Bent(PlanPoint[][] made, List<PlanPoint>[] levels, int joints)
        {
            var bent = (PlanPoint[][])made.Clone();
            for (int i = 1; i < bent.Length; i++)
                bent[i] = BalancedJoints.Place(levels[i], joints);
            return bent;
        }

        // All chains by as much: else one could come to lie across the next.
        private static List<PlanPoint> Straightened(List<PlanPoint> level, double share)
        {
            PlanPoint root = level[0], tip = level[level.Count - 1];
            PlanPoint[] path = Polyline.Even(level, k_Places);
            for (int k = 1; k < k_Places - 1; k++)
                path[k] += (root + (tip - root) * ((double)k / (k_Places - 1)) - path[k]) * share;
            return new List<PlanPoint>(path);
        }

        // Evenly along a path and on to the end of a tail.
        private PlanPoint[] Jointed(List<PlanPoint> path, OutlineStretch? tail, int joints)
        {
            if (tail is OutlineStretch beyond)
                path.Add(m_Marks.Trimmed.EndOf(beyond));
            PlanPoint[] chain = Polyline.Even(path, joints);
            ChainInset.Apply(chain, m_Outline);
            return chain;
        }

        // Straight across spikes; out to the very end where the tip itself is one.
        private List<PlanPoint> LeadingEdge()
        {
            bool isPointed = m_Marks.Trimmed.TryFindTail(m_Marks.Tip, out OutlineStretch point);
            double trimmedTo = isPointed ? point.from : m_Marks.Tip;
            List<PlanPoint> path = m_Marks.Trimmed.Along(m_Marks.LeadingRoot, trimmedTo);
            for (double s = trimmedTo + m_Outline.Step; s < m_Marks.Tip; s += m_Outline.Step)
                path.Add(m_Outline.At(s));
            if (isPointed)
                path.Add(m_Outline.At(m_Marks.Tip));
            return path;
        }

        // Out along the first chain, along the margin and back along the last; the base closes the rim.
        private FanField Field(PlanPoint[] first, IReadOnlyList<PlanPoint> last)
        {
            var rim = new List<PlanPoint>(first);
            var values = new List<double>();
            while (values.Count < rim.Count)
                values.Add(0.0);
            for (int k = 1; k < m_Margin.Points.Count; k++)
            {
                rim.Add(m_Margin.Points[k]);
                values.Add(m_Margin.Shares[k]);
            }

            for (int j = last.Count - 1; j >= 0; j--)
            {
                rim.Add(last[j]);
                values.Add(1.0);
            }

            return new FanField(rim, values, m_Margin.Points[0] - m_Marks.Base);
        }
    }
}
