using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Authoring
{
    /// <summary>
    /// Finds the hinge as the place on the outline from which the lines of the wing run away, because veins come together there.
    /// </summary>
    internal static class VeinFocus
    {
        /// <summary>Number of places of the outline that are tried.</summary>
        private const int k_Places = 160;

        /// <summary>Pixels over which a line's direction is taken, as a share of the wing's extent.</summary>
        private const double k_Stretch = 0.015;

        /// <summary>Sine of the angle within which a line counts as running away from a place.</summary>
        private const double k_Sine = 0.2;

        /// <summary>
        /// Least share of all lines that run away from the hinge, and factor by which it exceeds that of any place far from it.
        /// </summary>
        private const double k_LeastShare = 0.45, k_Lead = 1.25;

        /// <summary>Least length of all lines, in extents of the wing.</summary>
        private const double k_LeastLength = 1.0;

        /// <summary>Distance, as a share of the extent, above which places are far.</summary>
        private const double k_Far = 0.3;

        /// <summary>Finds the hinge, in the graph's pixels; null when the lines do not tell.</summary>
        public static PlanPoint? Find(VeinGraph graph, Polyline rim, double extent)
        {
            if (graph.Count < k_LeastLength * extent)
                return null;
            List<(PlanPoint Place, PlanPoint Direction)> lines = Directions(graph, Math.Max(3, (int)(k_Stretch * extent)));
            double[] shares = new double[k_Places];
            int best = 0;
            for (int k = 0; k < k_Places; k++)
            {
                shares[k] = ShareFrom(rim.At(rim.Length * k / k_Places), lines);
                best = shares[k] > shares[best] ? k : best;
            }

            PlanPoint focus = rim.At(rim.Length * best / k_Places);
            for (int k = 0; k < k_Places; k++)
            {
                bool isFar = (rim.At(rim.Length * k / k_Places) - focus).LengthSquared > k_Far * k_Far * extent * extent;
                if (isFar && shares[best] < k_Lead * shares[k])
                    return null;
            }

            return shares[best] >= k_LeastShare ? focus : (PlanPoint?)null;
        }

        // Of the lines at some distance; close by, all directions are alike.
        private static double ShareFrom(PlanPoint from, List<(PlanPoint Place, PlanPoint Direction)> lines)
        {
            int running = 0;
            foreach ((PlanPoint place, PlanPoint direction) in lines)
            {
                PlanPoint away = place - from;
                double cross = PlanPoint.Cross(away, direction);
                if (cross * cross < k_Sine * k_Sine * away.LengthSquared)
                    running++;
            }

            return (double)running / Math.Max(1, lines.Count);
        }

        private static List<(PlanPoint Place, PlanPoint Direction)> Directions(VeinGraph graph, int steps)
        {
            var directions = new List<(PlanPoint Place, PlanPoint Direction)>();
            for (int vertex = 0; vertex < graph.Count; vertex += 2)
            {
                if (graph.IsNode(vertex))
                    continue;
                PlanPoint along = graph[graph.Walk(vertex, 0, steps)] - graph[graph.Walk(vertex, 1, steps)];
                double length = Math.Sqrt(along.LengthSquared);
                if (length > steps)
                    directions.Add((graph[vertex], along * (1.0 / length)));
            }

            return directions;
        }
    }
}
