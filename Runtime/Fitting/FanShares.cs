using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>
    /// Divides the fan among the chains: evenly, except that the chain closest to a tail goes into it, and that no other ends at a tail or
    /// in a cleft. Where the margin shows the rays of a fan, chains run along rays.
    /// </summary>
    internal sealed class FanShares
    {
        private readonly WingMargin m_Margin;
        private readonly List<(double From, double To)> m_Closed = new List<(double, double)>();
        private readonly OutlineStretch?[] m_Tails;
        private readonly double[] m_Shares;

        public FanShares(WingLandmarks marks, WingMargin margin, int chains)
        {
            m_Margin = margin;
            m_Tails = new OutlineStretch?[chains];
            m_Shares = new double[chains];
            if (marks.Rays.Count > 0)
            {
                ShareRays(marks.Rays);
                return;
            }

            var tails = new List<OutlineStretch>();
            foreach (OutlineStretch tail in marks.Trimmed.Tails)
                AddClosed(marks, tail, tails);
            foreach (OutlineStretch cleft in marks.Trimmed.Clefts)
                AddClosed(marks, cleft, null);
            m_Closed.Sort();
            tails.Sort((a, b) => a.from.CompareTo(b.from));
            Distribute(marks, tails);
        }

        /// <summary>Share of the fan before a chain: 0 for the first, 1 for the last, rising.</summary>
        public double this[int chain] => m_Shares[chain];

        /// <summary>The tail that a chain goes into, or null.</summary>
        public OutlineStretch? TailOf(int chain) => m_Tails[chain];

        private void AddClosed(WingLandmarks marks, OutlineStretch stretch, List<OutlineStretch> tails)
        {
            if (stretch.from < marks.Tip || stretch.from >= marks.Last)
                return;
            m_Closed.Add((m_Margin.ShareAt(stretch.from), m_Margin.ShareAt(stretch.to)));
            tails?.Add(stretch);
        }

        // Between one chain whose place is given and the next, the others lie evenly over what is open.
        private void Distribute(WingLandmarks marks, List<OutlineStretch> tails)
        {
            int last = m_Shares.Length - 1, before = 0;
            foreach (OutlineStretch tail in tails)
            {
                PlanPoint end = marks.Trimmed.EndOf(tail);
                if (tail.Contains(marks.Last))
                {
                    m_Tails[last] = marks.IsLastInReach(end) ? tail : (OutlineStretch?)null;
                    continue;
                }

                double towards = m_Margin.ShareTowards(end, tail);
                int chain = Math.Max(Math.Min((int)Math.Round(towards * last), last - 1), before + 1);
                if (chain >= last)
                    continue;
                m_Tails[chain] = tail;
                m_Shares[chain] = m_Margin.ShareAt(0.5 * (tail.from + tail.to));
                Fill(before, chain);
                before = chain;
            }

            m_Shares[last] = 1.0;
            Fill(before, last);
        }

        // Evenly by the number of rays; along rays where there are enough.
        private void ShareRays(IReadOnlyList<double> rays)
        {
            int last = m_Shares.Length - 1;
            for (int i = 0; i <= last; i++)
            {
                double at = (double)i * (rays.Count - 1) / last;
                if (rays.Count > last)
                    at = Math.Round(at);
                int ray = Math.Min((int)at, rays.Count - 2);
                m_Shares[i] = m_Margin.ShareAt(rays[ray] + (rays[ray + 1] - rays[ray]) * (at - ray));
            }
        }

        private void Fill(int before, int after)
        {
            double from = Open(m_Shares[before]), to = Open(m_Shares[after]);
            for (int i = before + 1; i < after; i++)
                m_Shares[i] = Inverse(from + (to - from) * (i - before) / (after - before));
        }

        // How much of the margin before a share is open.
        private double Open(double share)
        {
            double open = share;
            foreach ((double from, double to) in m_Closed)
                open -= Math.Min(Math.Max(share - from, 0.0), to - from);
            return open;
        }

        private double Inverse(double open)
        {
            double share = open;
            foreach ((double from, double to) in m_Closed)
                share += share > from ? to - from : 0.0;
            return share;
        }
    }
}
