using System;
using System.Globalization;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Refuses a mesh that is not the wing its skeleton was made for. A mesh fits when the joints reach between half and twice as far from
    /// the hinge along the span as the mesh, and at least half of the wing's area lies within 0.15 wing lengths of the fan of joints.
    /// </summary>
    internal static class FitCheck
    {
        /// <summary>Distance from the fan, wing lengths, up to which a part of the wing is near.</summary>
        private const float k_Near = 0.15f;

        /// <summary>Share of the wing's area that must be near.</summary>
        private const double k_LeastNearShare = 0.5;

        /// <summary>Shortest and longest reach of the joints, wing lengths.</summary>
        private const float k_LeastReach = 0.5f;
        private const float k_MostReach = 2f;

        public static void Run(string name, RestSkeleton rest, SurfaceTriangles triangles, CellPoint[] centres)
        {
            if (triangles.Count == 0)
                throw new ArgumentException($"{name} has no triangle with an area.");

            double near = 0.0;
            for (int k = 0; k < triangles.Count; k++)
            {
                if (Distance(rest, centres[k], triangles.centres[k]) <= k_Near)
                    near += triangles.areas[k];
            }

            if (near < k_LeastNearShare * triangles.Area)
            {
                string share = (100.0 * near / triangles.Area).ToString("F0", CultureInfo.InvariantCulture);
                throw new ArgumentException($"{name} is far away from its skeleton: {share} % of its area lies near the joints.");
            }

            float reach = 0f;
            foreach (float3 joint in rest.joints)
                reach = math.max(reach, joint.x);
            if (reach < k_LeastReach || reach > k_MostReach)
            {
                string times = reach.ToString("G3", CultureInfo.InvariantCulture);
                throw new ArgumentException(
                    $"{name} does not fit its skeleton: along the span the joints reach {times} times as far as the mesh.");
            }
        }

        private static float Distance(RestSkeleton rest, CellPoint at, float3 point)
        {
            int joint = rest.FirstJoint(at.cell), next = joint + rest.jointsPerChain;
            var heights = new float4(rest.joints[joint].y, rest.joints[joint + 1].y, rest.joints[next].y, rest.joints[next + 1].y);
            float height = point.y - math.dot(at.Weights, heights);
            return math.sqrt(at.distance * at.distance + height * height);
        }
    }
}
