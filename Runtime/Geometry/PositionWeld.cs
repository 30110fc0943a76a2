using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Geometry
{
    /// <summary>Joins vertices at the same place, which importers split where texture coordinates or normals change.</summary>
    /// <remarks>
    /// Each vertex enters the cells of a fine grid that a small box around it touches, and all in one cell are joined. So vertices
    /// within <see cref="k_Near"/> always are, those further apart than a cell's diagonal never are directly, and the work is linear.
    /// </remarks>
    internal static class PositionWeld
    {
        // Shares of the largest coordinate: some roundings of a float (6e-8 each), and what is still far below any detail of a mesh.
        private const double k_Near = 5e-7;
        private const double k_Cell = 2e-6;

        // Keeps cell borders away from the plane of symmetry, where vertices crowd.
        private const double k_Shift = 0.381966;

        private const int k_Bits = 21;

        public static void Join(Vector3[] positions, int[] used, DisjointSets sets)
        {
            var size = LargestCoordinate(positions, used);
            var scale = size > 0.0 ? 1.0 / (k_Cell * size) : 1.0;
            var first = new Dictionary<long, int>(2 * used.Length);
            foreach (var vertex in used)
            {
                if (!IsFinite(positions[vertex]))
                    continue;
                var x = Cells(positions[vertex].x, scale);
                var y = Cells(positions[vertex].y, scale);
                var z = Cells(positions[vertex].z, scale);
                for (var i = x.low; i <= x.high; i++)
                {
                    for (var j = y.low; j <= y.high; j++)
                    {
                        for (var k = z.low; k <= z.high; k++)
                            Enter(first, Key(i, j, k), vertex, sets);
                    }
                }
            }
        }

        private static void Enter(Dictionary<long, int> first, long key, int vertex, DisjointSets sets)
        {
            if (first.TryGetValue(key, out var other))
                sets.Join(vertex, other);
            else
                first.Add(key, vertex);
        }

        private static (long low, long high) Cells(double coordinate, double scale)
        {
            var place = coordinate * scale + k_Shift;
            const double reach = 0.5 * k_Near / k_Cell;
            return ((long)Math.Floor(place - reach), (long)Math.Floor(place + reach));
        }

        private static long Key(long x, long y, long z)
        {
            const long k_Mask = (1L << k_Bits) - 1;
            var packed = (x & k_Mask) << (2 * k_Bits) | (y & k_Mask) << k_Bits | (z & k_Mask);

            // An odd factor keeps keys apart and spreads them over the dictionary.
            return unchecked(packed * -7046029254386353131L);
        }

        private static double LargestCoordinate(Vector3[] positions, int[] used)
        {
            var largest = 0f;
            foreach (var vertex in used)
            {
                if (!IsFinite(positions[vertex]))
                    continue;
                for (var axis = 0; axis < 3; axis++)
                    largest = Mathf.Max(largest, Mathf.Abs(positions[vertex][axis]));
            }

            return largest;
        }

        private static bool IsFinite(Vector3 p) => !float.IsNaN(p.x + p.y + p.z) && !float.IsInfinity(p.x + p.y + p.z);
    }
}
