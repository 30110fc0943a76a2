using System;
using System.Collections.Generic;
using System.Linq;
using Unity.Mathematics;

namespace Alate.Tests.Insects
{
    /// <summary>Finds triangles that pass through each other.</summary>
    internal static class TriangleCrossing
    {
        /// <summary>
        /// Pairs of triangles of one or two sheets that pass through each other; neighbours, which share a corner, do not count.
        /// </summary>
        /// <param name="places">[vertex] Of all triangles.</param>
        /// <param name="one">Corners of triangles.</param>
        /// <param name="other">Corners of triangles; the same list for a sheet and itself.</param>
        public static int Count(float3[] places, List<int3> one, List<int3> other)
        {
            var boxes = other.Select(triangle => (Triangle: triangle, Min: Min(places, triangle), Max: Max(places, triangle)))
                .OrderBy(box => box.Min.x).ToList();
            float widest = boxes.Max(box => box.Max.x - box.Min.x);
            float[] starts = boxes.Select(box => box.Min.x).ToArray();
            int crossings = 0;
            foreach (int3 triangle in one)
            {
                float3 min = Min(places, triangle), max = Max(places, triangle);
                int first = Array.BinarySearch(starts, min.x - widest);
                first = first < 0 ? ~first : first;
                while (first > 0 && starts[first - 1] >= min.x - widest)
                    first--;
                for (int k = first; k < boxes.Count && starts[k] <= max.x; k++)
                {
                    if (math.all(boxes[k].Min <= max) && math.all(boxes[k].Max >= min)
                        && !ShareCorner(triangle, boxes[k].Triangle) && Cross(places, triangle, boxes[k].Triangle))
                    {
                        crossings++;
                    }
                }
            }

            return ReferenceEquals(one, other) ? crossings / 2 : crossings;
        }

        private static bool ShareCorner(int3 one, int3 other) =>
            math.any(one == other.x) || math.any(one == other.y) || math.any(one == other.z);

        private static bool Cross(float3[] places, int3 one, int3 other)
        {
            for (int k = 0; k < 3; k++)
            {
                if (Pierces(places[one[k]], places[one[(k + 1) % 3]], places, other)
                    || Pierces(places[other[k]], places[other[(k + 1) % 3]], places, one))
                {
                    return true;
                }
            }

            return false;
        }

        // Both ends on different sides of the plane, and the line on the inner side of all three edges.
        private static bool Pierces(float3 from, float3 to, float3[] places, int3 triangle)
        {
            float3 a = places[triangle.x], b = places[triangle.y], c = places[triangle.z];
            if (Volume(a, b, c, from) * Volume(a, b, c, to) >= 0f)
                return false;
            float ab = Volume(from, to, a, b), bc = Volume(from, to, b, c), ca = Volume(from, to, c, a);
            return (ab > 0f && bc > 0f && ca > 0f) || (ab < 0f && bc < 0f && ca < 0f);
        }

        private static float Volume(float3 a, float3 b, float3 c, float3 d) => math.dot(math.cross(b - a, c - a), d - a);

        private static float3 Min(float3[] places, int3 triangle) =>
            math.min(places[triangle.x], math.min(places[triangle.y], places[triangle.z]));

        private static float3 Max(float3[] places, int3 triangle) =>
            math.max(places[triangle.x], math.max(places[triangle.y], places[triangle.z]));
    }
}
