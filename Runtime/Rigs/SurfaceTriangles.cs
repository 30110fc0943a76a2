using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The triangles of a surface that have an area, each place once: of a double-sided wing, one side. Two triangles are one when
    /// their corners lie at exactly the same three places, whatever their order and indices.
    /// </summary>
    internal sealed class SurfaceTriangles
    {
        /// <summary>Doubled area, L², below which a triangle has none.</summary>
        private const float k_LeastDoubledArea = 1e-12f;

        /// <summary>Vertex indices of the corners.</summary>
        public readonly List<int3> corners = new List<int3>();

        /// <summary>Areas, L².</summary>
        public readonly List<float> areas = new List<float>();

        /// <summary>Unit normals on the dorsal side.</summary>
        public readonly List<float3> normals = new List<float3>();

        /// <summary>Centroids.</summary>
        public readonly List<float3> centres = new List<float3>();

        /// <param name="points">Vertex positions in the wing frame.</param>
        /// <param name="triangles">Three indices a triangle.</param>
        public SurfaceTriangles(float3[] points, int[] triangles)
        {
            int[] places = Places(points);
            var seen = new HashSet<(int, int, int)>();
            for (int k = 0; k < triangles.Length; k += 3)
            {
                var corner = new int3(triangles[k], triangles[k + 1], triangles[k + 2]);
                float3 a = points[corner.x], b = points[corner.y], c = points[corner.z];
                float3 doubled = math.cross(b - a, c - a);
                float length = math.length(doubled);
                if (!(length > k_LeastDoubledArea) || !seen.Add(Sorted(places[corner.x], places[corner.y], places[corner.z])))
                    continue;
                corners.Add(corner);
                areas.Add(0.5f * length);
                normals.Add((doubled.y < 0f ? -doubled : doubled) / length);
                centres.Add((a + b + c) / 3f);
                Area += 0.5 * length;
            }
        }

        public int Count => corners.Count;

        /// <summary>Area of the wing, L².</summary>
        public double Area { get; }

        // One number per place, so that split vertices of a seam are equal.
        private static int[] Places(float3[] points)
        {
            var places = new int[points.Length];
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

        private static (int, int, int) Sorted(int a, int b, int c)
        {
            int low = math.min(a, math.min(b, c)), high = math.max(a, math.max(b, c));
            return (low, a + b + c - low - high, high);
        }
    }
}
