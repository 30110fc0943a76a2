using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>Finds the veins that run from near the hinge to the margin among all that a picture shows.</summary>
    internal sealed class RadialVeins
    {
        /// <summary>Least share of the way from the hinge to the margin on which a vein is visible.</summary>
        private const double k_LeastCoverage = 0.55;

        /// <summary>Largest share of the way that two different veins have in common.</summary>
        private const double k_MostShared = 0.7;

        /// <summary>Length over which a vein's direction at its end is measured, as a share of the wing's length.</summary>
        private const double k_EndLength = 0.06;

        /// <summary>
        /// Ignored length at the end of a vein, and distance from the margin beyond which that end turns outward; shares of the wing's
        /// length.
        /// </summary>
        private const double k_Bent = 0.015, k_FarRim = 0.08;

        /// <summary>
        /// Cosine of the largest angle between a vein's end and the line from the hinge; other veins run along the margin or across.
        /// </summary>
        private const double k_LeastCosine = 0.5;

        /// <summary>
        /// Distance from the outline, as a share of the wing's length and at most of its mean chord, and share of its way, within which a
        /// line is the outline's own.
        /// </summary>
        private const double k_RimLine = 0.03, k_RimChord = 0.2, k_AlongRim = 0.6;

        /// <summary>Largest distance between the points of a vein, as a share of the wing's length.</summary>
        private const double k_Step = 0.007;

        private readonly VeinGraph m_Graph;
        private readonly VeinTree m_Tree;
        private readonly Polyline m_Rim;
        private readonly PlanPoint m_Hinge;
        private readonly double m_Length;

        private RadialVeins(VeinGraph graph, Polyline rim, PlanPoint hinge, double length)
        {
            m_Graph = graph;
            m_Tree = new VeinTree(graph, hinge);
            m_Rim = rim;
            m_Hinge = hinge;
            m_Length = length;
        }

        /// <summary>Finds the veins, the best covered first. All places and lengths are in the pixels of the graph, z up.</summary>
        public static List<RadialVein> Find(VeinGraph graph, Polyline rim, PlanPoint hinge, double length)
        {
            var search = new RadialVeins(graph, rim, hinge, length);
            var found = new List<(RadialVein Vein, List<int> Way)>();
            for (int vertex = 0; vertex < graph.Count; vertex++)
            {
                if (graph.IsNode(vertex) && search.Try(vertex, out RadialVein vein, out List<int> way))
                    found.Add((vein, way));
            }

            found.Sort((a, b) => b.Vein.Coverage.CompareTo(a.Vein.Coverage));
            var kept = new List<RadialVein>();
            var taken = new List<HashSet<int>>();
            foreach ((RadialVein vein, List<int> way) in found)
            {
                if (taken.Exists(other => way.FindAll(other.Contains).Count > k_MostShared * way.Count))
                    continue;
                taken.Add(new HashSet<int>(way));
                kept.Add(vein);
            }

            return kept;
        }

        private bool Try(int vertex, out RadialVein vein, out List<int> way)
        {
            vein = null;
            way = m_Tree.WayTo(vertex);
            double covered = m_Tree.CoveredTo(vertex) - Trim(way);
            if (way.Count < 3)
                return false;
            PlanPoint end = m_Graph[way[way.Count - 1]], outward = PlanPoint.Unit(end - m_Hinge), direction = DirectionAtEnd(way);
            if (PlanPoint.Dot(direction, outward) < k_LeastCosine)
                return false;
            double rest = m_Rim.RayDistance(end, direction, -1, out int met);
            if (rest > k_FarRim * m_Length)
            {
                direction = PlanPoint.Unit(direction + outward);
                rest = m_Rim.RayDistance(end, direction, -1, out met);
            }

            double whole = Math.Sqrt((m_Graph[way[0]] - m_Hinge).LengthSquared)
                + Polyline.LengthOf(way.ConvertAll(pixel => m_Graph[pixel])) + rest;
            if (met < 0 || covered < k_LeastCoverage * whole)
                return false;
            var path = new List<PlanPoint> { m_Hinge };
            foreach (int pixel in way)
                path.Add(m_Graph[pixel]);
            PlanPoint tip = end + direction * rest;
            path.Add(tip);
            if (IsRim(way))
                return false;
            PlanPoint[] even = Polyline.Even(path, Math.Max(3, 1 + (int)Math.Ceiling(Polyline.LengthOf(path) / (k_Step * m_Length))));
            vein = new RadialVein(Polyline.Smoothed(even), m_Rim.Nearest(tip), covered / whole);
            return true;
        }

        private bool IsRim(List<int> way)
        {
            double close = Math.Min(k_RimLine * m_Length, k_RimChord * Polygon.Area(m_Rim.Points) / m_Length);
            int along =
                way.FindAll(pixel => (m_Rim.At(m_Rim.Nearest(m_Graph[pixel])) - m_Graph[pixel]).LengthSquared < close * close).Count;
            return along > k_AlongRim * way.Count;
        }

        // Lines bend where they meet the margin; the direction before that is the better one.
        private double Trim(List<int> way)
        {
            double cut = 0.0;
            while (way.Count > 3 && cut < k_Bent * m_Length)
            {
                cut += Math.Sqrt((m_Graph[way[way.Count - 1]] - m_Graph[way[way.Count - 2]]).LengthSquared);
                way.RemoveAt(way.Count - 1);
            }

            return cut;
        }

        private PlanPoint DirectionAtEnd(List<int> way)
        {
            int from = way.Count - 1;
            PlanPoint end = m_Graph[way[from]];
            while (from > 0 && (end - m_Graph[way[from]]).LengthSquared < k_EndLength * k_EndLength * m_Length * m_Length)
                from--;
            return PlanPoint.Unit(end - m_Graph[way[from]]);
        }
    }
}
