using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Fitting
{
    /// <summary>Orders the open edges of a wing, seen from above, into its outline and the rims of its holes.</summary>
    internal sealed class OutlineWalk
    {
        private readonly PlanPoint[] m_Plan;
        private readonly Dictionary<int, List<int>> m_Neighbours = new Dictionary<int, List<int>>();
        private readonly MeshEdges m_Walked = new MeshEdges();

        /// <summary>Places counterclockwise round the wing; empty without edges.</summary>
        public readonly List<int> outline = new List<int>();

        /// <summary>Places round each hole.</summary>
        public readonly List<List<int>> holes = new List<List<int>>();

        /// <param name="plan">[place]</param>
        /// <param name="edges">Pairs of places, each once.</param>
        public OutlineWalk(PlanPoint[] plan, List<(int A, int B)> edges)
        {
            m_Plan = plan;
            foreach ((int a, int b) in edges)
            {
                NeighboursOf(a).Add(b);
                NeighboursOf(b).Add(a);
            }

            if (edges.Count == 0)
                return;
            WalkAround();
            foreach ((int a, int b) in edges)
            {
                if (!IsWalked(a, b))
                    holes.Add(WalkHole(a, b));
            }
        }

        // Round the outside, which stays on the right hand: at each place along the first edge counterclockwise of the way back.
        private void WalkAround()
        {
            int start = Outermost();
            int next = FirstTurn(start, new PlanPoint(-1.0, 0.0), -1), first = next;
            int at = start;
            do
            {
                outline.Add(at);
                m_Walked.Add(at, next);
                int before = at;
                at = next;
                next = FirstTurn(at, m_Plan[before] - m_Plan[at], before);
            }
            while ((at != start || next != first) && outline.Count <= 4 * m_Neighbours.Count);
        }

        private List<int> WalkHole(int start, int second)
        {
            var hole = new List<int> { start };
            m_Walked.Add(start, second);
            int at = second;
            while (at != start)
            {
                hole.Add(at);
                int here = at;
                int next = NeighboursOf(at).FindIndex(place => !IsWalked(here, place));
                if (next < 0)
                    break;
                at = NeighboursOf(at)[next];
                m_Walked.Add(here, at);
            }

            return hole;
        }

        private int Outermost()
        {
            int found = -1;
            foreach (int place in m_Neighbours.Keys)
            {
                if (found < 0 || m_Plan[place].x < m_Plan[found].x
                    || (m_Plan[place].x == m_Plan[found].x && m_Plan[place].z < m_Plan[found].z))
                {
                    found = place;
                }
            }

            return found;
        }

        // Back along the same edge only where there is no other.
        private int FirstTurn(int at, PlanPoint back, int before)
        {
            int found = before;
            double least = double.MaxValue;
            foreach (int place in NeighboursOf(at))
            {
                PlanPoint way = m_Plan[place] - m_Plan[at];
                double turn = Elementary.Atan2(PlanPoint.Cross(back, way), PlanPoint.Dot(back, way));
                turn = turn < 0.0 ? turn + 2.0 * Math.PI : turn;
                if (place != before && turn < least)
                {
                    least = turn;
                    found = place;
                }
            }

            return found;
        }

        private List<int> NeighboursOf(int place)
        {
            if (!m_Neighbours.TryGetValue(place, out List<int> neighbours))
                m_Neighbours.Add(place, neighbours = new List<int>());
            return neighbours;
        }

        private bool IsWalked(int a, int b) => m_Walked.Uses(a, b) > 0;
    }
}
