using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Triangles of a wing's mesh, on which joints can be placed. Mesh space.</summary>
    internal sealed class SnapSurface
    {
        private readonly Vector3[] m_Positions;
        private readonly int[] m_Triangles;

        /// <param name="surface">Indices of its triangles are within its positions; the arrays are kept, not copied.</param>
        public SnapSurface(SurfaceMesh surface)
        {
            Wing = surface;
            m_Positions = surface.positions;
            m_Triangles = surface.triangles;
        }

        /// <summary>Surface of the whole wing.</summary>
        public SurfaceMesh Wing { get; }

        /// <summary>The point of the surface closest to a point; the point itself where there is no finite triangle.</summary>
        public Vector3 ClosestPoint(Vector3 point)
        {
            float3 p = point, best = p;
            float least = float.PositiveInfinity;
            for (int k = 0; k + 2 < m_Triangles.Length; k += 3)
            {
                float3 candidate = ClosestOnTriangle(p, Corner(k), Corner(k + 1), Corner(k + 2));
                float distance = math.distancesq(candidate, p);
                if (!(distance < least))
                    continue;
                least = distance;
                best = candidate;
            }

            return best;
        }

        /// <summary>The first point where a ray meets the surface, from either side.</summary>
        /// <param name="origin">Where the ray begins.</param>
        /// <param name="direction">Of any length but zero.</param>
        /// <param name="point">Where it meets the surface.</param>
        public bool TryHit(Vector3 origin, Vector3 direction, out Vector3 point)
        {
            float nearest = float.PositiveInfinity;
            for (int k = 0; k + 2 < m_Triangles.Length; k += 3)
            {
                if (TryTriangle(origin, direction, Corner(k), Corner(k + 1), Corner(k + 2), out float along) && along < nearest)
                    nearest = along;
            }

            bool hit = nearest < float.PositiveInfinity;
            point = hit ? origin + nearest * direction : origin;
            return hit;
        }

        private float3 Corner(int index) => m_Positions[m_Triangles[index]];

        // By the regions of the triangle's plane: a corner, an edge or the inside is closest.
        private static float3 ClosestOnTriangle(float3 p, float3 a, float3 b, float3 c)
        {
            float3 ab = b - a, ac = c - a, normal = math.cross(ab, ac);
            float area = math.lengthsq(normal);
            if (area > 0f)
            {
                float v = math.dot(math.cross(p - a, ac), normal) / area, w = math.dot(math.cross(ab, p - a), normal) / area;
                if (v >= 0f && w >= 0f && v + w <= 1f)
                    return a + v * ab + w * ac;
            }

            float3 best = ClosestOnSegment(p, a, b), next = ClosestOnSegment(p, b, c);
            best = math.distancesq(next, p) < math.distancesq(best, p) ? next : best;
            next = ClosestOnSegment(p, c, a);
            return math.distancesq(next, p) < math.distancesq(best, p) ? next : best;
        }

        private static float3 ClosestOnSegment(float3 p, float3 a, float3 b)
        {
            float3 along = b - a;
            float length = math.lengthsq(along);
            return length > 0f ? a + along * math.saturate(math.dot(p - a, along) / length) : a;
        }

        private static bool TryTriangle(float3 origin, float3 direction, float3 a, float3 b, float3 c, out float along)
        {
            float3 ab = b - a, ac = c - a, across = math.cross(direction, ac), from = origin - a, turned = math.cross(from, ab);
            float volume = math.dot(ab, across);
            float u = math.dot(from, across) / volume, v = math.dot(direction, turned) / volume;
            along = math.dot(ac, turned) / volume;

            // Comparisons with what a flat triangle makes of a division by zero are false.
            return u >= 0f && v >= 0f && u + v <= 1f && along >= 0f && along < float.PositiveInfinity;
        }
    }
}
