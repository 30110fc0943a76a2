using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Geometry
{
    /// <summary>Gives vertices that lie in one place one number, whatever seams of normals or texture split them.</summary>
    internal static class VertexWelding
    {
        /// <summary>Cells are far larger than the tolerance, so that most vertices need to look into one only.</summary>
        private const float k_TolerancesPerCell = 64f;

        /// <summary>[vertex] The first vertex within the tolerance of it, itself included.</summary>
        public static int[] Places(float3[] points, float tolerance)
        {
            float perUnit = 1f / (k_TolerancesPerCell * tolerance);
            var places = new int[points.Length];
            var next = new int[points.Length];
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
