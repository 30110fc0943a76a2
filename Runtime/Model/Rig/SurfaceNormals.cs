using Unity.Mathematics;

namespace Alate
{
    /// <summary>Rest normals for skinning, mesh space.</summary>
    internal static class SurfaceNormals
    {
        private const float k_LeastLengthSquared = 1e-12f, k_UnitTolerance = 1e-5f;

        /// <summary>
        /// Makes the normals: the mesh's own, made unit; where there are none, or one is zero or not finite, the area-weighted mean of the
        /// vertex's triangles. Where that vanishes, as between the two sides of a double-sided wing, and at unused vertices: the up axis.
        /// </summary>
        public static float3[] Make(SurfaceMesh surface, in WingFrame frame)
        {
            var normals = new float3[surface.positions.Length];
            bool given = surface.normals != null && surface.normals.Length > 0;
            bool complete = given;
            for (int k = 0; given && k < normals.Length; k++)
            {
                normals[k] = Unit(surface.normals[k]);
                complete &= IsUsable(normals[k]);
            }

            if (complete)
                return normals;
            float3[] computed = Compute(surface, frame);
            for (int k = 0; k < normals.Length; k++)
            {
                if (!given || !IsUsable(normals[k]))
                    normals[k] = IsUsable(computed[k]) ? math.normalize(computed[k]) : frame.axes.c1;
            }

            return normals;
        }

        // In units of the wing's area, so that the size of the mesh does not matter.
        private static float3[] Compute(SurfaceMesh surface, in WingFrame frame)
        {
            var sums = new float3[surface.positions.Length];
            for (int k = 0; k < surface.triangles.Length; k += 3)
            {
                int a = surface.triangles[k], b = surface.triangles[k + 1], c = surface.triangles[k + 2];
                float3 origin = surface.positions[a];
                float3 toB = ((float3)surface.positions[b] - origin) / frame.length;
                float3 toC = ((float3)surface.positions[c] - origin) / frame.length;
                float3 doubled = math.cross(toB, toC);
                sums[a] += doubled;
                sums[b] += doubled;
                sums[c] += doubled;
            }

            return sums;
        }

        // One that is unit already stays as it is.
        private static float3 Unit(float3 normal) =>
            IsUsable(normal) && math.abs(math.lengthsq(normal) - 1f) > k_UnitTolerance ? math.normalize(normal) : normal;

        private static bool IsUsable(float3 normal) =>
            math.all(math.isfinite(normal)) && math.lengthsq(normal) > k_LeastLengthSquared;
    }
}
