using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Finds where a ray meets the plane in which a joint is dragged.</summary>
    internal static class DragPlane
    {
        /// <summary>Sine between ray and plane below which the plane is seen edge-on.</summary>
        private const float k_LeastSine = 0.05f;

        /// <summary>
        /// The point of the plane through <paramref name="anchor"/> under the ray. Where the plane is seen edge-on, the screen's plane
        /// is taken, and the point brought back into the plane. False where the ray points away.
        /// </summary>
        public static bool TryPoint(Ray ray, Vector3 anchor, Vector3 normal, out Vector3 point)
        {
            normal = (Vector3)math.normalizesafe((float3)normal / math.cmax(math.abs((float3)normal)));
            if (Mathf.Abs(Vector3.Dot(ray.direction, normal)) >= k_LeastSine)
                return TryMeet(ray, anchor, normal, out point);
            bool met = TryMeet(ray, anchor, ray.direction, out point);
            point -= normal * Vector3.Dot(point - anchor, normal);
            return met;
        }

        private static bool TryMeet(Ray ray, Vector3 anchor, Vector3 normal, out Vector3 point)
        {
            float along = Vector3.Dot(anchor - ray.origin, normal) / Vector3.Dot(ray.direction, normal);
            bool ahead = along > 0f && along < float.PositiveInfinity;
            point = ahead ? ray.GetPoint(along) : anchor;
            return ahead;
        }
    }
}
