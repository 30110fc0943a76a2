using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>
    /// Finds the shortest way from the hinge to every pixel of the veins (Dijkstra, 1959), where ground off the veins is costly.
    /// </summary>
    internal sealed class VeinTree
    {
        /// <summary>Cost of the way from the hinge to the first vein over that of one as long on veins.</summary>
        private const double k_OffVein = 2.0;

        private readonly double[] m_Costs;
        private readonly int[] m_Parents;
        private readonly double[] m_Covered;

        /// <param name="graph">The veins.</param>
        /// <param name="hinge">In the graph's pixels.</param>
        public VeinTree(VeinGraph graph, PlanPoint hinge)
        {
            m_Costs = new double[graph.Count];
            m_Parents = new int[graph.Count];
            m_Covered = new double[graph.Count];
            var open = new SortedSet<(double Cost, int Vertex)>();
            for (int k = 0; k < graph.Count; k++)
            {
                m_Costs[k] = k_OffVein * Math.Sqrt((graph[k] - hinge).LengthSquared);
                m_Parents[k] = -1;
                open.Add((m_Costs[k], k));
            }

            while (open.Count > 0)
            {
                int vertex = open.Min.Vertex;
                open.Remove(open.Min);
                foreach (VeinLink link in graph.LinksOf(vertex))
                    Relax(vertex, link, open);
            }
        }

        /// <summary>Length on veins of the way to a pixel.</summary>
        public double CoveredTo(int vertex) => m_Covered[vertex];

        /// <summary>The pixels on the way to a pixel, from the hinge on.</summary>
        public List<int> WayTo(int vertex)
        {
            var way = new List<int>();
            for (int at = vertex; at >= 0; at = m_Parents[at])
                way.Add(at);
            way.Reverse();
            return way;
        }

        private void Relax(int vertex, VeinLink link, SortedSet<(double Cost, int Vertex)> open)
        {
            double cost = m_Costs[vertex] + link.dearness * link.length;
            if (cost >= m_Costs[link.to])
                return;
            open.Remove((m_Costs[link.to], link.to));
            m_Costs[link.to] = cost;
            m_Parents[link.to] = vertex;
            m_Covered[link.to] = m_Covered[vertex] + (link.IsBridge ? 0.0 : link.length);
            open.Add((cost, link.to));
        }
    }
}
