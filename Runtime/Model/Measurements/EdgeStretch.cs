using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Measures the stretch of the edges of a mesh against their length at rest.</summary>
    internal sealed class EdgeStretch
    {
        private readonly Edge[] m_Edges;

        /// <summary>Takes every edge of a mesh once; edges of no length are left out.</summary>
        /// <param name="rest">[vertex] Rest positions, any unit.</param>
        /// <param name="triangles">Three vertex indices a triangle.</param>
        public EdgeStretch(float3[] rest, int[] triangles)
        {
            var all = new MeshEdges(triangles);
            var edges = new List<Edge>(all.Count);
            for (int k = 0; k < all.Count; k++)
            {
                (int a, int b) = all[k];
                float length = math.distance(rest[a], rest[b]);
                if (length > 0f)
                    edges.Add(new Edge { a = a, b = b, length = length });
            }

            m_Edges = edges.ToArray();
        }

        /// <summary>Edges of the mesh.</summary>
        public int Count => m_Edges.Length;

        /// <summary>Vertices at both ends of an edge.</summary>
        public (int A, int B) this[int edge] => (m_Edges[edge].a, m_Edges[edge].b);

        /// <summary>Writes |l/l₀ − 1| of every edge.</summary>
        /// <param name="positions">[vertex] Deformed positions in the unit of the rest positions.</param>
        /// <param name="stretches">[edge] Where to, <see cref="Count"/> entries.</param>
        public void Measure(float3[] positions, Span<float> stretches)
        {
            for (int k = 0; k < m_Edges.Length; k++)
                stretches[k] = math.abs(math.distance(positions[m_Edges[k].a], positions[m_Edges[k].b]) / m_Edges[k].length - 1f);
        }

        /// <summary>The value that the given share of all values does not exceed; puts the values into another order.</summary>
        /// <param name="values">One or more; those that are no number count as the least.</param>
        /// <param name="share">0 to 1; 1 is the largest value.</param>
        public static float Percentile(float[] values, float share)
        {
            int rank = math.clamp((int)math.ceil(share * values.Length) - 1, 0, values.Length - 1);
            int from = 0, to = values.Length - 1;
            for (int k = 0; k < values.Length; k++)
            {
                if (float.IsNaN(values[k]))
                    Swap(values, k, from++);
            }

            // Parts the values about one of them, and goes on in the part that holds the rank.
            while (from < to && from <= rank)
            {
                float middle = values[from + (to - from) / 2];
                int low = from, high = to;
                while (low <= high)
                {
                    while (values[low] < middle)
                        low++;
                    while (values[high] > middle)
                        high--;
                    if (low <= high)
                        Swap(values, low++, high--);
                }

                if (rank > high && rank < low)
                    break;
                (from, to) = rank <= high ? (from, high) : (low, to);
            }

            return values[rank];
        }

        private static void Swap(float[] values, int a, int b) => (values[a], values[b]) = (values[b], values[a]);

        private struct Edge
        {
            public int a, b;
            public float length;
        }
    }
}
