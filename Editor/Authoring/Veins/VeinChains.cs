using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Lays the chains of a skeleton along the veins that were chosen for them, and the other chains between those.</summary>
    internal sealed class VeinChains
    {
        /// <summary>
        /// Distance of a vein from the hinge and from the other veins from which on its chain follows it; shares of the wing's length.
        /// </summary>
        private const double k_FromHinge = 0.06, k_FromOthers = 0.025;

        /// <summary>Distance from the other veins on slender wings, as a share of the mean distance between chains.</summary>
        private const double k_FromNeighbours = 0.35;

        /// <summary>The tip stays inside the outline by this share of the wing's length.</summary>
        private const double k_Inside = 0.004;

        /// <summary>Most by which a chain between two others is stretched to reach the margin.</summary>
        private const double k_MostStretch = 1.35;

        /// <summary>Share of a chain that surely lies within the wing.</summary>
        private const double k_Begin = 0.3;

        /// <summary>
        /// Number of steps of a vein that give its direction at the hinge, and largest distance of its line from the wing's base, in wing
        /// lengths.
        /// </summary>
        private const int k_RootSteps = 8;
        private const double k_OffBase = 0.03;

        private readonly IReadOnlyList<PlanPoint[]> m_Fitted;
        private readonly RadialVein[] m_Followed;
        private readonly Polyline m_Rim;
        private readonly double m_Length;
        private readonly double m_Apart;
        private readonly bool m_OwnRoots;

        private VeinChains(IReadOnlyList<PlanPoint[]> fitted, RadialVein[] followed, Polyline rim, double length, bool ownRoots)
        {
            m_OwnRoots = ownRoots;
            m_Fitted = fitted;
            m_Followed = followed;
            m_Rim = rim;
            m_Length = length;
            double meanChord = Polygon.Area(rim.Points) / length;
            m_Apart = Math.Min(k_FromOthers * length, k_FromNeighbours * meanChord / (fitted.Count - 1));
            Chains = new PlanPoint[fitted.Count][];
            Shares = new double[fitted.Count];
        }

        /// <summary>The chains, with as many joints as the fitted ones.</summary>
        public PlanPoint[][] Chains { get; }

        /// <summary>[chain] Share of its length on its vein; 0 without one.</summary>
        public double[] Shares { get; }

        /// <summary>Lays all chains.</summary>
        /// <param name="fitted">Chains as fitted to the outline, from leading to trailing edge.</param>
        /// <param name="followed">[chain] The vein to follow, or null.</param>
        /// <param name="rim">The outline.</param>
        /// <param name="length">Of the wing.</param>
        /// <param name="ownRoots">Whether chains begin where their veins do, not at the fitted roots.</param>
        public static VeinChains Lay(IReadOnlyList<PlanPoint[]> fitted, RadialVein[] followed, Polyline rim, double length, bool ownRoots)
        {
            var chains = new VeinChains(fitted, followed, rim, length, ownRoots);
            for (int i = 0; i < fitted.Count; i++)
                chains.Chains[i] = followed[i] != null ? chains.Along(i) : fitted[i];
            for (int i = 1; i < fitted.Count; i++)
            {
                if (followed[i] == null)
                    chains.LayBetween(i);
            }

            return chains;
        }

        private PlanPoint[] Along(int chain)
        {
            PlanPoint[] vein = m_Followed[chain].Path;
            int start = 1;
            for (int k = 1; k + 2 < vein.Length; k++)
            {
                if ((vein[k] - vein[0]).LengthSquared < k_FromHinge * k_FromHinge * m_Length * m_Length || !IsApart(chain, vein[k]))
                    start = k + 1;
            }

            // A straight bone bridges the stretch that veins share.
            var path = new List<PlanPoint> { Root(chain, vein, start) };
            for (int k = start; k < vein.Length; k++)
                path.Add(vein[k]);
            PlanPoint last = path[path.Count - 1] - path[path.Count - 2];
            path[path.Count - 1] = path[path.Count - 1] - last * Math.Min(0.9, k_Inside * m_Length / Math.Sqrt(last.LengthSquared));
            Shares[chain] = 1.0 - Math.Sqrt((path[1] - path[0]).LengthSquared) / Polyline.LengthOf(path);
            return Polyline.Even(path, m_Fitted[chain].Length);
        }

        // Where the vein came from, if that lies on the base; else where the fitted chain begins.
        private PlanPoint Root(int chain, PlanPoint[] vein, int start)
        {
            PlanPoint fitted = m_Fitted[chain][0];
            if (!m_OwnRoots)
                return fitted;
            var back = PlanPoint.Unit(vein[start] - vein[Math.Min(vein.Length - 1, start + k_RootSteps)]);
            double reach = m_Rim.RayDistance(vein[start], back, -1, out int met) - k_Inside * m_Length;
            PlanPoint root = vein[start] + back * reach;
            bool isOnBase = PlanPoint.DistanceSquared(
                root, m_Fitted[0][0], m_Fitted[m_Fitted.Count - 1][0]) < k_OffBase * k_OffBase * m_Length * m_Length;
            return met >= 0 && isOnBase ? root : fitted;
        }

        private bool IsApart(int chain, PlanPoint point)
        {
            for (int other = 0; other < m_Followed.Length; other++)
            {
                if (other != chain && m_Followed[other] != null && Polyline.Distance(m_Followed[other].Path, point) < m_Apart)
                    return false;
            }

            return true;
        }

        // A chain without a vein keeps its share of the way between the nearest ones that have one.
        private void LayBetween(int chain)
        {
            int before = chain - 1, after = chain + 1;
            while (after < m_Followed.Length && m_Followed[after] == null)
                after++;
            if (after == m_Followed.Length)
                return;
            double share = 1.0 / (after - before);
            var joints = new PlanPoint[m_Fitted[chain].Length];
            for (int j = 0; j < joints.Length; j++)
                joints[j] = Chains[before][j] + (Chains[after][j] - Chains[before][j]) * share;
            Stretch(joints);
            Chains[chain] = joints;
        }

        // To where the way from the root first meets the margin.
        private void Stretch(PlanPoint[] joints)
        {
            PlanPoint root = joints[0], whole = joints[joints.Length - 1] - root, begin = root + whole * k_Begin;
            double length = Math.Sqrt(whole.LengthSquared), rest = m_Rim.RayDistance(begin, whole * (1.0 / length), -1, out int met);
            if (met < 0)
                return;
            double factor = Math.Min(k_MostStretch, k_Begin + (rest - k_Inside * m_Length) / length);
            for (int j = 1; j < joints.Length; j++)
                joints[j] = root + (joints[j] - root) * factor;
        }
    }
}
