using System;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>
    /// Edges between vertices of a mesh, whichever way round, each once: in the order in which they are first met, with their numbers of
    /// uses.
    /// </summary>
    internal sealed class MeshEdges
    {
        private const int k_LeastCapacity = 16;

        private Edge[] m_Edges;

        // [hash] The newest edge of this hash, from 1; 0 for none. As long as m_Edges, a power of two.
        private int[] m_Newest;

        /// <summary>No edges yet, with room for some.</summary>
        public MeshEdges(int capacity = 0)
        {
            int length = k_LeastCapacity;
            while (length < capacity)
                length *= 2;
            m_Edges = new Edge[length];
            m_Newest = new int[length];
        }

        /// <summary>Edges of triangles; each triangle is one use of its three.</summary>
        /// <param name="triangles">Three vertex indices a triangle.</param>
        public MeshEdges(int[] triangles)
            : this(triangles.Length / 2)
        {
            for (int k = 0; k < triangles.Length; k += 3)
                Add(new int3(triangles[k], triangles[k + 1], triangles[k + 2]));
        }

        public int Count { get; private set; }

        /// <summary>Both ends of an edge, the lower index first.</summary>
        public (int Low, int High) this[int edge] => (m_Edges[edge].low, m_Edges[edge].high);

        /// <summary>Times that an edge was added: the triangles on it.</summary>
        public int Uses(int edge) => m_Edges[edge].uses;

        /// <summary>Times that the edge between two vertices was added; 0 where there is none.</summary>
        public int Uses(int a, int b)
        {
            int edge = Find(math.min(a, b), math.max(a, b));
            return edge < 0 ? 0 : m_Edges[edge].uses;
        }

        /// <summary>Adds one use of an edge.</summary>
        /// <returns>True where the edge is new.</returns>
        public bool Add(int a, int b)
        {
            int low = math.min(a, b), high = math.max(a, b), edge = Find(low, high);
            if (edge >= 0)
            {
                m_Edges[edge].uses++;
                return false;
            }

            if (Count == m_Edges.Length)
                Grow();
            m_Edges[Count] = new Edge { low = low, high = high, uses = 1 };
            Link(Count++);
            return true;
        }

        /// <summary>Adds one use of each edge of a triangle.</summary>
        public void Add(int3 triangle)
        {
            Add(triangle.x, triangle.y);
            Add(triangle.y, triangle.z);
            Add(triangle.z, triangle.x);
        }

        private int Find(int low, int high)
        {
            int edge = m_Newest[Hash(low, high)] - 1;
            while (edge >= 0 && (m_Edges[edge].low != low || m_Edges[edge].high != high))
                edge = m_Edges[edge].before;
            return edge;
        }

        private void Link(int edge)
        {
            ref int newest = ref m_Newest[Hash(m_Edges[edge].low, m_Edges[edge].high)];
            m_Edges[edge].before = newest - 1;
            newest = edge + 1;
        }

        private void Grow()
        {
            Array.Resize(ref m_Edges, 2 * Count);
            m_Newest = new int[2 * Count];
            for (int edge = 0; edge < Count; edge++)
                Link(edge);
        }

        // Neighbouring vertices have neighbouring indices: the odd factors spread them.
        private int Hash(int low, int high)
        {
            uint mixed = ((uint)low * 0x9E3779B1u + (uint)high) * 0x85EBCA77u;
            return (int)((mixed ^ (mixed >> 15)) & (uint)(m_Newest.Length - 1));
        }

        private struct Edge
        {
            public int low, high, uses, before;
        }
    }
}
