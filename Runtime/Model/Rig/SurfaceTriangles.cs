using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Triangles of a surface that have an area, each place once, with the area of one side of the wing. Two triangles are one place when
    /// their corners lie at exactly equal points, whatever their order and indices. On a surface that is closed, every edge between an even
    /// number of triangles, a triangle has half its area where it has no double: a thin shell.
    /// </summary>
    internal sealed class SurfaceTriangles
    {
        /// <summary>Doubled area, L², below which a triangle counts as empty.</summary>
        public const float LeastDoubledArea = 1e-12f;

        /// <summary>Vertex indices of the corners.</summary>
        public readonly List<int3> corners;

        /// <summary>Areas of one side of the wing, L².</summary>
        public readonly List<float> areas;

        /// <summary>Centroids of the triangles.</summary>
        public readonly List<float3> centres;

        /// <param name="points">Vertex positions in the wing frame.</param>
        /// <param name="triangles">Three indices a triangle.</param>
        public SurfaceTriangles(float3[] points, int[] triangles)
        {
            int[] places = VertexWeld.Exact(points);
            int most = triangles.Length / 3;
            corners = new List<int3>(most);
            areas = new List<float>(most);
            centres = new List<float3>(most);
            var known = new Dictionary<(int, int, int), int>(most);
            var doubled = new List<bool>(most);
            for (int k = 0; k < triangles.Length; k += 3)
            {
                var corner = new int3(triangles[k], triangles[k + 1], triangles[k + 2]);
                (int, int, int) place = Sorted(places[corner.x], places[corner.y], places[corner.z]);
                if (known.TryGetValue(place, out int first))
                {
                    doubled[first] = true;
                }
                else if (TryAdd(points, corner))
                {
                    known.Add(place, Count - 1);
                    doubled.Add(false);
                }
            }

            bool shell = IsClosed(places, triangles);
            for (int t = 0; t < Count; t++)
            {
                areas[t] *= shell && !doubled[t] ? 0.5f : 1f;
                Area += areas[t];
            }
        }

        public int Count => corners.Count;

        /// <summary>Area of the wing, L².</summary>
        public double Area { get; }

        private bool TryAdd(float3[] points, int3 corner)
        {
            float3 a = points[corner.x], b = points[corner.y], c = points[corner.z];
            float doubled = math.length(math.cross(b - a, c - a));
            if (!(doubled > LeastDoubledArea))
                return false;
            corners.Add(corner);
            areas.Add(0.5f * doubled);
            centres.Add((a + b + c) / 3f);
            return true;
        }

        private static bool IsClosed(int[] places, int[] triangles)
        {
            var edges = new MeshEdges(triangles.Length / 2);
            for (int k = 0; k < triangles.Length; k += 3)
                edges.Add(new int3(places[triangles[k]], places[triangles[k + 1]], places[triangles[k + 2]]));
            for (int k = 0; k < edges.Count; k++)
            {
                if (edges.Uses(k) % 2 == 1 && edges[k].Low != edges[k].High)
                    return false;
            }

            return true;
        }

        private static (int, int, int) Sorted(int a, int b, int c)
        {
            int low = math.min(a, math.min(b, c)), high = math.max(a, math.max(b, c));
            return (low, a + b + c - low - high, high);
        }
    }
}
