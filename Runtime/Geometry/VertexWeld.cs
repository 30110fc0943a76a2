using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Geometry
{
    /// <summary>Gives vertices that lie in one place one number, whatever seams of normals or texture split them.</summary>
    internal static class VertexWeld
    {
        /// <summary>Cells are far larger than the tolerance, so that most vertices need to look into one only.</summary>
        private const float k_TolerancesPerCell = 64f;

        /// <summary>Share of the largest coordinate: some roundings of a float (6e-8 each), far below any detail of a mesh.</summary>
        private const float k_Roundings = 1e-6f;

        /// <summary>Joins vertices that differ by roundings; those that are not finite stay alone.</summary>
        /// <param name="positions">[vertex]</param>
        /// <param name="used">The vertices that count, each once.</param>
        /// <param name="sets">Sets of vertices.</param>
        public static void Join(Vector3[] positions, int[] used, DisjointSets sets)
        {
            int[] finite = Array.FindAll(used, vertex => math.all(math.isfinite((float3)positions[vertex])));
            float3[] points = Array.ConvertAll(finite, vertex => (float3)positions[vertex]);
            float largest = 0f;
            foreach (float3 point in points)
                largest = math.max(largest, math.cmax(math.abs(point)));
            int[] places = Places(points, math.max(k_Roundings * largest, 1e-30f));
            for (int k = 0; k < places.Length; k++)
                sets.Join(finite[k], finite[places[k]]);
        }

        /// <summary>[vertex] The first vertex at exactly the same place, itself included.</summary>
        public static int[] Exact(float3[] points)
        {
            int[] places = new int[points.Length];
            var known = new Dictionary<(float, float, float), int>(points.Length);
            for (int k = 0; k < points.Length; k++)
            {
                // Adding zero makes −0 the same key as 0.
                (float, float, float) key = (points[k].x + 0f, points[k].y + 0f, points[k].z + 0f);
                if (!known.TryGetValue(key, out places[k]))
                {
                    places[k] = k;
                    known.Add(key, k);
                }
            }

            return places;
        }

        /// <summary>[vertex] The first vertex within the tolerance of it, itself included.</summary>
        public static int[] Places(float3[] points, float tolerance)
        {
            float perUnit = 1f / (k_TolerancesPerCell * tolerance);
            int[] places = new int[points.Length];
            int[] next = new int[points.Length];
            var newest = new Dictionary<(int, int, int), int>(points.Length);
            for (int k = 0; k < points.Length; k++)
            {
                places[k] = Find(points, k, tolerance, perUnit, newest, next);
                if (places[k] != k)
                    continue;
                (int, int, int) cell = Cell(points[k] * perUnit);
                next[k] = newest.TryGetValue(cell, out int before) ? before : -1;
                newest[cell] = k;
            }

            return places;
        }

        private static int Find(
            float3[] points, int vertex, float tolerance, float perUnit, Dictionary<(int, int, int), int> newest, int[] next)
        {
            (int x, int y, int z) low = Cell((points[vertex] - tolerance) * perUnit);
            (int x, int y, int z) high = Cell((points[vertex] + tolerance) * perUnit);
            int found = vertex;
            for (int x = low.x; x <= high.x; x++)
            {
                for (int y = low.y; y <= high.y; y++)
                {
                    for (int z = low.z; z <= high.z; z++)
                    {
                        int other = newest.TryGetValue((x, y, z), out int first) ? first : -1;
                        for (; other >= 0; other = next[other])
                        {
                            if (math.distancesq(points[other], points[vertex]) <= tolerance * tolerance)
                                found = Math.Min(found, other);
                        }
                    }
                }
            }

            return found;
        }

        private static (int, int, int) Cell(float3 scaled) =>
            ((int)math.floor(scaled.x), (int)math.floor(scaled.y), (int)math.floor(scaled.z));
    }
}
