using System.Collections.Generic;

namespace Alate
{
    /// <summary>
    /// Lays the chains of a wing: the first along its leading edge, the last straight to the trailing edge, those between along level
    /// lines of a <see cref="FanField"/>. A chain that ends next to a tail goes on into it.
    /// </summary>
    internal sealed class FanChains
    {
        private readonly ClosedCurve m_Outline;
        private readonly WingLandmarks m_Marks;
        private readonly WingMargin m_Margin;
        private readonly int m_Chains;
        private readonly int m_Joints;

        public FanChains(ClosedCurve outline, WingLandmarks marks, int chains, int joints)
        {
            m_Outline = outline;
            m_Marks = marks;
            m_Margin = new WingMargin(marks);
            m_Chains = chains;
            m_Joints = joints;
        }

        /// <summary>[chain][joint] in the wing's view.</summary>
        public PlanPoint[][] Lay()
        {
            var made = new PlanPoint[m_Chains][];
            made[0] = BalancedJoints.Place(LeadingEdge(), m_Joints);
            ChainInset.Apply(made[0], m_Outline);
            List<PlanPoint> lastPath = new InnerPath(m_Outline).Find(m_Marks.TrailingRoot, m_Marks.Last);
            FanField field = Field(made[0], lastPath);
            var shares = new FanShares(m_Marks, m_Margin, m_Chains);
            PlanPoint firstRoot = made[0][0], lastRoot = lastPath[0];
            for (int i = 1; i < m_Chains; i++)
            {
                double share = shares[i];
                List<PlanPoint> path = i == m_Chains - 1
                    ? lastPath
                    : LevelLine.Trace(field, share, firstRoot + (lastRoot - firstRoot) * share, m_Margin.At(share));
                if (shares.TailOf(i) is OutlineStretch tail)
                    path.Add(m_Marks.Trimmed.EndOf(tail));
                made[i] = Jointed(path);
            }

            ChainOrder.Untangle(made);
            return made;
        }

        private PlanPoint[] Jointed(IReadOnlyList<PlanPoint> path)
        {
            PlanPoint[] chain = OpenPath.Even(path, m_Joints);
            ChainInset.Apply(chain, m_Outline);
            return chain;
        }

        // Straight across spikes; out to the very end where the tip itself is one.
        private List<PlanPoint> LeadingEdge()
        {
            bool isPointed = m_Marks.Trimmed.TryFindTail(m_Marks.Tip, out OutlineStretch point);
            double trimmedTo = isPointed ? point.from : m_Marks.Tip;
            List<PlanPoint> path = OpenPath.Along(m_Marks.Trimmed, m_Marks.LeadingRoot, trimmedTo);
            for (double s = trimmedTo + m_Outline.Step; s < m_Marks.Tip; s += m_Outline.Step)
                path.Add(m_Outline.At(s));
            if (isPointed)
                path.Add(m_Outline.At(m_Marks.Tip));
            return path;
        }

        // Out along the first chain, along the margin and back along the last; the base closes the rim.
        private FanField Field(PlanPoint[] first, List<PlanPoint> last)
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
