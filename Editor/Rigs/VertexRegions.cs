using System;
using System.Collections.Generic;
using Alate.Geometry;

namespace Alate.Editor
{
    /// <summary>Finds connected regions of a mesh by a condition.</summary>
    internal static class VertexRegions
    {
        /// <summary>
        /// Finds the vertices of triangles for which a condition holds, one ascending list for each region connected by edges.
        /// </summary>
        public static List<List<int>> Find(SurfaceMesh surface, Predicate<int> holds)
        {
            var held = new SortedSet<int>(Array.FindAll(surface.triangles, holds));
            var sets = new DisjointSets(surface.positions.Length);
            int[] indices = surface.triangles;
            for (int k = 0; k + 2 < indices.Length; k += 3)
            {
                Join(indices[k], indices[k + 1]);
                Join(indices[k + 1], indices[k + 2]);
                Join(indices[k + 2], indices[k]);
            }

            var regions = new SortedDictionary<int, List<int>>();
            foreach (int vertex in held)
            {
                int root = sets.Find(vertex);
                if (!regions.TryGetValue(root, out List<int> region))
                    regions.Add(root, region = new List<int>());
                region.Add(vertex);
            }

            return new List<List<int>>(regions.Values);

            void Join(int a, int b)
            {
                if (held.Contains(a) && held.Contains(b))
                    sets.Join(a, b);
            }
        }
    }
}
