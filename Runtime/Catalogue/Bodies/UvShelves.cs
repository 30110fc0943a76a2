using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Lays the unrolled parts of a body side by side in the unit square, all to one scale: in shelves, the longest parts first.
    /// </summary>
    internal static class UvShelves
    {
        private const float k_Gap = 0.006f;
        private const int k_Halvings = 24;

        /// <summary>A rectangle of the unit square for each part.</summary>
        /// <param name="extents">Width and height of each part, any one unit, above 0.</param>
        public static Rect[] Lay(IReadOnlyList<Vector2> extents)
        {
            int[] order = new int[extents.Count];
            float largest = 0f;
            for (int k = 0; k < order.Length; k++)
            {
                order[k] = k;
                largest = Math.Max(largest, Math.Max(extents[k].x, extents[k].y));
            }

            Array.Sort(order, (one, other) => Compare(extents, one, other));
            var rectangles = new Rect[order.Length];
            float fits = 0f, fails = 1f / largest;
            for (int step = 0; step < k_Halvings; step++)
            {
                float scale = 0.5f * (fits + fails);
                if (TryLay(extents, order, scale, rectangles))
                    fits = scale;
                else
                    fails = scale;
            }

            TryLay(extents, order, fits, rectangles);
            return rectangles;
        }

        private static bool TryLay(IReadOnlyList<Vector2> extents, int[] order, float scale, Rect[] rectangles)
        {
            float x = k_Gap, y = k_Gap, shelf = 0f;
            foreach (int part in order)
            {
                Vector2 size = scale * extents[part];
                if (x + size.x + k_Gap > 1f)
                {
                    x = k_Gap;
                    y += shelf + k_Gap;
                    shelf = 0f;
                }

                rectangles[part] = new Rect(x, y, size.x, size.y);
                x += size.x + k_Gap;
                shelf = Math.Max(shelf, size.y);
                if (x > 1f || y + shelf + k_Gap > 1f)
                    return false;
            }

            return true;
        }

        private static int Compare(IReadOnlyList<Vector2> extents, int one, int other)
        {
            int byHeight = extents[other].y.CompareTo(extents[one].y);
            return byHeight != 0 ? byHeight : one.CompareTo(other);
        }
    }
}
