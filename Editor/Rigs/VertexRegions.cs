using System;
using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Finds connected regions of a mesh by a condition.</summary>
    internal static class VertexRegions
    {
        /// <summary>
        /// Finds the vertices of triangles for which a condition holds, one ascending list for each region connected by edges.
        /// </summary>
        public static List<List<int>> Find(in WingSurface surface, Predicate<int> holds)
        {
            var parent = new Dictionary<int, int>();
            int[] indices = surface.triangles;
            foreach (int vertex in indices)
            {
                if (!parent.ContainsKey(vertex) && holds(vertex))
                    parent.Add(vertex, vertex);
            }

            for (int k = 0; k + 2 < indices.Length; k += 3)
            {
                Join(parent, indices[k], indices[k + 1]);
                Join(parent, indices[k + 1], indices[k + 2]);
                Join(parent, indices[k + 2], indices[k]);
            }

            var regions = new SortedDictionary<int, List<int>>();
            var vertices = new List<int>(parent.Keys);
            vertices.Sort();
            foreach (int vertex in vertices)
            {
                int root = Root(parent, vertex);
                if (!regions.TryGetValue(root, out List<int> region))
                    regions.Add(root, region = new List<int>());
                region.Add(vertex);
            }

            return new List<List<int>>(regions.Values);
        }

        private static void Join(Dictionary<int, int> parent, int a, int b)
        {
            if (!parent.ContainsKey(a) || !parent.ContainsKey(b))
                return;
            int rootA = Root(parent, a), rootB = Root(parent, b);
            parent[Math.Max(rootA, rootB)] = Math.Min(rootA, rootB);
        }

        private static int Root(Dictionary<int, int> parent, int vertex)
        {
            while (parent[vertex] != vertex)
            {
                // Shortens the way for the next time.
                parent[vertex] = parent[parent[vertex]];
                vertex = parent[vertex];
            }

            return vertex;
        }
    }
}
