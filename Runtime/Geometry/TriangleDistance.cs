using UnityEngine;

namespace Alate.Geometry
{
    /// <summary>Distance of a point from a triangle: from its face, an edge or a corner, whichever is nearest.</summary>
    internal static class TriangleDistance
    {
        /// <summary>Square of the distance, in the unit of the points squared.</summary>
        public static float Square(Vector3 point, Vector3 a, Vector3 b, Vector3 c)
        {
            var normal = Vector3.Cross(b - a, c - a);
            float square = normal.sqrMagnitude;
            if (square > 0f && IsOver(point, a, b, normal) && IsOver(point, b, c, normal) && IsOver(point, c, a, normal))
            {
                float height = Vector3.Dot(point - a, normal);
                return height * height / square;
            }

            return Mathf.Min(ToEdge(point, a, b), Mathf.Min(ToEdge(point, b, c), ToEdge(point, c, a)));
        }

        private static bool IsOver(Vector3 point, Vector3 from, Vector3 to, Vector3 normal) =>
            Vector3.Dot(Vector3.Cross(to - from, point - from), normal) >= 0f;

        private static float ToEdge(Vector3 point, Vector3 from, Vector3 to)
        {
            Vector3 edge = to - from;
            float length = edge.sqrMagnitude;
            float share = length > 0f ? Mathf.Clamp01(Vector3.Dot(point - from, edge) / length) : 0f;
            return (point - from - share * edge).sqrMagnitude;
        }
    }
}
