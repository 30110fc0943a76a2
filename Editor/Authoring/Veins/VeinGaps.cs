using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Bridges the gaps of veins: joins each end, and each fork from which no line goes on, to the line straight ahead.</summary>
    internal sealed class VeinGaps
    {
        /// <summary>Longest gap that is bridged, a share of the wing's length.</summary>
        private const double k_Gap = 0.07;

        /// <summary>Cost of a gap that lies in a vein's way and of one that does not, over that of a vein as long.</summary>
        private const double k_Straight = 1.5, k_Sideways = 2.5;

        /// <summary>
        /// Length of the stretch before a gap that gives a vein's direction, as a share of the longest gap, and cosine within which the gap
        /// must lie.
        /// </summary>
        private const double k_Stretch = 0.4, k_Cosine = 0.9;

        /// <summary>
        /// Stretch at the end of a vein that is bent sideways, as ridges are at a line's end; a share of the longest gap.
        /// </summary>
        private const double k_Bent = 0.25;

        private readonly VeinGraph m_Graph;
        private readonly double m_Longest;
        private readonly int m_Stretch;
        private readonly int m_Bent;
        private readonly int[] m_Parts;

        private VeinGaps(VeinGraph graph, double longest)
        {
            m_Graph = graph;
            m_Longest = longest;
            m_Stretch = Math.Max(3, (int)(k_Stretch * longest));
            m_Bent = Math.Max(2, (int)(k_Bent * longest));
            m_Parts = new int[graph.Count];
            var joined = new DisjointSets(graph.Count);
            for (int vertex = 0; vertex < graph.Count; vertex++)
            {
                foreach (VeinLink link in graph.LinksOf(vertex))
                    joined.Join(vertex, link.to);
            }

            for (int vertex = 0; vertex < graph.Count; vertex++)
                m_Parts[vertex] = joined.Find(vertex);
        }

        /// <summary>Joins the lines that the gaps of a graph part.</summary>
        /// <param name="graph">Without bridges.</param>
        /// <param name="length">Of the wing, pixels of the graph.</param>
        public static void Bridge(VeinGraph graph, double length)
        {
            var gaps = new VeinGaps(graph, k_Gap * length);
            for (int vertex = 0; vertex < graph.Count; vertex++)
            {
                if (graph.LinesAt(vertex) == 1)
                    gaps.FromEnd(vertex);
                else if (graph.IsNode(vertex))
                    gaps.FromFork(vertex);
            }
        }

        // To the nearest pixel of every other part, and from where it begins to bend to the one straight ahead.
        private void FromEnd(int end)
        {
            var nearest = new Dictionary<int, int>();
            for (int vertex = 0; vertex < m_Graph.Count; vertex++)
            {
                double distance = m_Graph.Distance(vertex, end);
                if (distance > m_Longest || m_Parts[vertex] == m_Parts[end])
                    continue;
                if (!nearest.TryGetValue(m_Parts[vertex], out int before) || distance < m_Graph.Distance(before, end))
                    nearest[m_Parts[vertex]] = vertex;
            }

            foreach (int vertex in nearest.Values)
                m_Graph.Join(end, vertex, k_Sideways);
            var bent = new List<int> { end };
            for (int step = 1; step <= m_Bent; step++)
                bent.Add(m_Graph.Walk(end, 0, step));
            int last = bent[m_Bent];
            GoOn(last, m_Graph[last] - m_Graph[m_Graph.Walk(end, 0, m_Bent + m_Stretch)], bent);
        }

        private void FromFork(int fork)
        {
            int lines = m_Graph.LinesAt(fork);
            for (int line = 0; line < lines; line++)
            {
                PlanPoint ahead = m_Graph[fork] - m_Graph[m_Graph.Walk(fork, line, m_Stretch)];
                bool isLong = ahead.LengthSquared > 0.25 * m_Stretch * m_Stretch, goesOn = false;
                for (int other = 0; other < lines; other++)
                    goesOn |= other != line && IsAlong(ahead, m_Graph[m_Graph.Walk(fork, other, m_Stretch)] - m_Graph[fork]);
                if (isLong && !goesOn)
                    GoOn(fork, ahead, new List<int> { fork });
            }
        }

        private void GoOn(int from, PlanPoint ahead, List<int> excluded)
        {
            int found = -1;
            for (int vertex = 0; vertex < m_Graph.Count; vertex++)
            {
                double distance = m_Graph.Distance(vertex, from);
                bool isNearer = distance <= m_Longest && (found < 0 || distance < m_Graph.Distance(found, from));
                if (isNearer && !excluded.Contains(vertex) && IsAlong(ahead, m_Graph[vertex] - m_Graph[from]))
                    found = vertex;
            }

            if (found >= 0)
                m_Graph.Join(from, found, k_Straight);
        }

        private static bool IsAlong(PlanPoint ahead, PlanPoint way)
        {
            double cosine = PlanPoint.Dot(ahead, way);
            return cosine > 0.0 && cosine * cosine > k_Cosine * k_Cosine * ahead.LengthSquared * way.LengthSquared;
        }
    }
}
