using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate.Fitting
{
    /// <summary>
    /// The open edges of a triangle mesh: those of one triangle only. Where a vertex lies on the inside of an open edge (a T-junction)
    /// the edge is cut there, and pieces that then lie on both sides are no longer open.
    /// </summary>
    internal sealed class SheetBoundary
    {
        private readonly float3[] m_Points;
        private readonly float m_Tolerance;

        /// <summary>Pairs of places.</summary>
        public readonly List<(int A, int B)> edges = new List<(int, int)>();

        /// <summary>Pairs of places that a T-junction ties together.</summary>
        public readonly List<(int A, int B)> junctions = new List<(int, int)>();

        /// <param name="points">[place]</param>
        /// <param name="triangles">Places.</param>
        /// <param name="tolerance">How far from an edge a vertex still lies on it.</param>
        public SheetBoundary(float3[] points, IReadOnlyList<int3> triangles, float tolerance)
        {
            m_Points = points;
            m_Tolerance = tolerance;
            List<(int A, int B)> open = OpenEdges(triangles);
            var pieces = new MeshEdges(open.Count);
            int[] ends = SortedEnds(open, out int axis);
            var cuts = new List<int>();
            foreach ((int a, int b) in open)
            {
                FindCuts(a, b, ends, axis, cuts);
                int from = a;
                foreach (int cut in cuts)
                {
                    pieces.Add(from, cut);
                    junctions.Add((a, cut));
                    from = cut;
                }

                pieces.Add(from, b);
            }

            for (int k = 0; k < pieces.Count; k++)
            {
                if (pieces.Uses(k) % 2 == 1)
                    edges.Add(pieces[k]);
            }
        }

        private static List<(int A, int B)> OpenEdges(IReadOnlyList<int3> triangles)
        {
            var all = new MeshEdges(3 * triangles.Count / 2);
            foreach (int3 triangle in triangles)
                all.Add(triangle);

            var open = new List<(int, int)>();
            for (int k = 0; k < all.Count; k++)
            {
                if (all.Uses(k) == 1)
                    open.Add(all[k]);
            }

            return open;
        }

        // The ends of open edges, sorted along the axis on which they spread most.
        private int[] SortedEnds(List<(int A, int B)> open, out int axis)
        {
            var ends = new HashSet<int>();
            float3 low = float.MaxValue, high = float.MinValue;
            foreach ((int a, int b) in open)
            {
                ends.Add(a);
                ends.Add(b);
                low = math.min(low, math.min(m_Points[a], m_Points[b]));
                high = math.max(high, math.max(m_Points[a], m_Points[b]));
            }

            float3 extent = high - low;
            int widest = extent.x >= extent.y ? 0 : 1;
            widest = extent[widest] >= extent.z ? widest : 2;
            int[] sorted = new int[ends.Count];
            ends.CopyTo(sorted);
            Array.Sort(sorted, (a, b) => m_Points[a][widest].CompareTo(m_Points[b][widest]));
            axis = widest;
            return sorted;
        }

        private void FindCuts(int a, int b, int[] ends, int axis, List<int> cuts)
        {
            cuts.Clear();
            float3 from = m_Points[a], along = m_Points[b] - from;
            float lengthSquared = math.lengthsq(along), tolerance = m_Tolerance;
            float low = math.min(from[axis], m_Points[b][axis]) - tolerance, high = math.max(from[axis], m_Points[b][axis]) + tolerance;
            for (int k = FirstAtLeast(ends, axis, low); k < ends.Length && m_Points[ends[k]][axis] <= high; k++)
            {
                if (ends[k] == a || ends[k] == b)
                    continue;
                float3 to = m_Points[ends[k]] - from;
                float share = math.dot(to, along) / lengthSquared;
                if (share > 0f && share < 1f && math.distancesq(to, share * along) <= tolerance * tolerance)
                    cuts.Add(ends[k]);
            }

            cuts.Sort((p, q) => math.dot(m_Points[p] - from, along).CompareTo(math.dot(m_Points[q] - from, along)));
        }

        private int FirstAtLeast(int[] ends, int axis, float value)
        {
            int low = 0, high = ends.Length;
            while (low < high)
            {
                int middle = (low + high) / 2;
                if (m_Points[ends[middle]][axis] < value)
                    low = middle + 1;
                else
                    high = middle;
            }

            return low;
        }
    }
}
