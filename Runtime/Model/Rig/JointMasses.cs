using System;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// Masses of the joints, of a wing with mass 1 spread evenly over its area, and the inertia of the joints beyond each bone.
    /// </summary>
    internal static class JointMasses
    {
        /// <summary>
        /// Least mass of a joint before the sum is made 1 again. A joint that carries no part of the mesh would otherwise be
        /// thrown about by any load, or divide it by zero.
        /// </summary>
        public const double LeastShare = 1e-4;

        /// <summary>m_i = Σ_t (A_t/A)(w_ia + w_ib + w_ic)/3, at least <see cref="LeastShare"/>; sum 1.</summary>
        public static float[] OfJoints(RestSkeleton rest, SurfaceTriangles triangles, CellPoint[] weights)
        {
            double[] shares = new double[triangles.Count];
            for (int t = 0; t < shares.Length; t++)
                shares[t] = triangles.areas[t] / (3.0 * triangles.Area);
            double[] sums = Sums(rest, triangles, weights, shares);
            double total = 0.0;
            for (int joint = 0; joint < sums.Length; joint++)
            {
                sums[joint] = Math.Max(sums[joint], LeastShare);
                total += sums[joint];
            }

            float[] masses = new float[sums.Length];
            for (int joint = 0; joint < sums.Length; joint++)
                masses[joint] = (float)(sums[joint] / total);
            return masses;
        }

        /// <summary>
        /// Sums for each joint its part of the triangles around it: a share for each corner of each triangle, by the corner's weights.
        /// </summary>
        public static double[] Sums(RestSkeleton rest, SurfaceTriangles triangles, CellPoint[] weights, double[] shares)
        {
            double[] sums = new double[rest.joints.Length];
            for (int t = 0; t < triangles.Count; t++)
            {
                int3 corner = triangles.corners[t];
                Add(rest, sums, weights[corner.x], shares[t]);
                Add(rest, sums, weights[corner.y], shares[t]);
                Add(rest, sums, weights[corner.z], shares[t]);
            }

            return sums;
        }

        /// <summary>Inertia of the joints beyond each bone, I_ij = Σ_{k&gt;j} m_ik |p_ik−p_ij|².</summary>
        public static float[] Inertias(RestSkeleton rest, float[] masses)
        {
            float[] inertias = new float[rest.BoneCount];
            for (int bone = 0; bone < inertias.Length; bone++)
            {
                int inner = rest.InnerJoint(bone), tip = Tip(rest, inner);
                for (int outer = inner + 1; outer <= tip; outer++)
                    inertias[bone] += masses[outer] * math.distancesq(rest.joints[outer], rest.joints[inner]);
            }

            return inertias;
        }

        /// <summary>
        /// Lever damping for joints k &gt; j of a chain: |p_ik−p_ij| Λ_ik, Λ_ik = Σ_{l&lt;k} |p_ik−p_il|: row sums, which keep the implicit
        /// bending step stable on soft wings. Index joint · m + k.
        /// </summary>
        public static float[] LeverDamping(RestSkeleton rest)
        {
            int m = rest.jointsPerChain;
            float[] levers = new float[rest.joints.Length * m];
            for (int joint = 0; joint < rest.joints.Length; joint++)
            {
                int root = joint - joint % m;
                for (int k = joint % m + 1; k < m; k++)
                {
                    float sum = 0f;
                    for (int l = 0; l < k; l++)
                        sum += math.distance(rest.joints[root + k], rest.joints[root + l]);
                    levers[joint * m + k] = math.distance(rest.joints[root + k], rest.joints[joint]) * sum;
                }
            }

            return levers;
        }

        private static int Tip(RestSkeleton rest, int joint) => joint - joint % rest.jointsPerChain + rest.jointsPerChain - 1;

        private static void Add(RestSkeleton rest, double[] sums, CellPoint at, double share)
        {
            int joint = rest.FirstJoint(at.cell), next = joint + rest.jointsPerChain;
            double u = at.u, v = at.v;
            sums[joint] += share * (1.0 - u) * (1.0 - v);
            sums[joint + 1] += share * (1.0 - u) * v;
            sums[next] += share * u * (1.0 - v);
            sums[next + 1] += share * u * v;
        }
    }
}
