using System;
using System.Collections.Generic;
using System.Globalization;
using Unity.Mathematics;

namespace Alate.Editor
{
    /// <summary>
    /// Finds what weakens a rig. A monarch's wing on its own skeleton, with three to eight chains and joints, has none of these.
    /// </summary>
    internal static class RigProblems
    {
        /// <summary>Distance from the fan of joints above which a vertex is far, wing lengths. The largest of a monarch is 0.047.</summary>
        public const float FarDistance = 0.06f;

        /// <summary>Share of the wing's area that roots alone may move.</summary>
        public const float HeldShare = 0.01f;

        /// <summary>
        /// Mass of a joint over the mean above which it is concentrated, and in any case the share of the wing's mass. A monarch's is up to
        /// 3.3 times.
        /// </summary>
        public const float MassOverMean = 5f, MassShare = 0.4f;

        /// <summary>Finds all weaknesses, those that forbid a rig first.</summary>
        public static List<RigProblem> Find(RigInspection rig)
        {
            var problems = new List<RigProblem>();
            if (rig.Misfit != null)
                problems.Add(new RigProblem(RigProblemKind.DoesNotFit, rig.frame.origin, AllJoints(rig), rig.Misfit));
            AddFarVertices(rig, problems);
            AddHeldTriangles(rig, problems);
            AddFlatTriangles(rig, problems);
            AddMasses(rig, problems);
            return problems;
        }

        /// <summary>Summary of the rig in one line: "2096 triangles, 257 patches, heaviest joint 9.7 %".</summary>
        public static string Summary(RigInspection rig)
        {
            float heaviest = 0f;
            foreach (float mass in rig.masses)
                heaviest = math.max(heaviest, mass);
            return $"{Count(rig.triangles.Count, "triangle", "triangles")}, "
                + $"{Count(rig.PatchCount, "patch", "patches")}, heaviest joint {Percent(heaviest)}";
        }

        private static void AddFarVertices(RigInspection rig, List<RigProblem> problems)
        {
            foreach (List<int> region in VertexRegions.Find(rig.Surface, vertex => rig.Distance(vertex) > FarDistance))
            {
                int farthest = region[0];
                foreach (int vertex in region)
                    farthest = rig.Distance(vertex) > rig.Distance(farthest) ? vertex : farthest;
                problems.Add(new RigProblem(
                    RigProblemKind.FarVertices, rig.Surface.positions[farthest], new[] { rig.Strongest(farthest) },
                    $"{Count(region.Count, "vertex lies", "vertices lie")} up to "
                    + $"{Percent(rig.Distance(farthest))} of the wing's length beside the joints."));
            }
        }

        private static void AddHeldTriangles(RigInspection rig, List<RigProblem> problems)
        {
            double held = 0.0;
            float most = 0f;
            float3 where = default;
            var roots = new SortedSet<JointIndex>();
            for (int t = 0; t < rig.triangles.Count; t++)
            {
                int3 corner = rig.triangles.corners[t];
                if (!IsHeld(rig, corner.x) || !IsHeld(rig, corner.y) || !IsHeld(rig, corner.z))
                    continue;
                held += rig.triangles.areas[t];
                roots.Add(rig.Strongest(corner.x));
                if (rig.triangles.areas[t] <= most)
                    continue;
                most = rig.triangles.areas[t];
                where = rig.frame.ToMesh(rig.triangles.centres[t]);
            }

            float share = (float)(held / rig.triangles.Area);
            if (share > HeldShare)
            {
                problems.Add(new RigProblem(RigProblemKind.HeldByRoots, where, new List<JointIndex>(roots),
                    $"{Percent(share)} of the wing's area hangs on roots alone and never bends."));
            }
        }

        private static void AddFlatTriangles(RigInspection rig, List<RigProblem> problems)
        {
            int flat = 0, first = -1;
            int[] indices = rig.Surface.triangles;
            for (int k = 0; k + 2 < indices.Length; k += 3)
            {
                float3 a = rig.points[indices[k]], b = rig.points[indices[k + 1]], c = rig.points[indices[k + 2]];
                if (math.length(math.cross(b - a, c - a)) > SurfaceTriangles.LeastDoubledArea)
                    continue;
                first = flat++ == 0 ? indices[k] : first;
            }

            if (flat > 0)
            {
                problems.Add(new RigProblem(RigProblemKind.NoArea, rig.Surface.positions[first], new[] { rig.Strongest(first) },
                    $"{Count(flat, "triangle has", "triangles have")} no area; remove them from the mesh."));
            }
        }

        private static void AddMasses(RigInspection rig, List<RigProblem> problems)
        {
            float limit = Math.Min(MassOverMean / rig.masses.Length, MassShare);
            for (int joint = 0; joint < rig.masses.Length; joint++)
            {
                JointIndex index = rig.Joint(joint);
                float mass = rig.masses[joint];
                JointIndex[] joints = new[] { index };
                if (mass > limit)
                {
                    problems.Add(new RigProblem(RigProblemKind.MassConcentrated, Place(rig, joint), joints,
                        $"Joint {index.joint} of chain {index.chain} carries {Percent(mass)} of the wing's mass."));
                }
                else if (mass <= (float)JointMasses.LeastShare)
                {
                    problems.Add(new RigProblem(RigProblemKind.NoMass, Place(rig, joint), joints,
                        $"Joint {index.joint} of chain {index.chain} carries no part of the mesh."));
                }
            }
        }

        private static bool IsHeld(RigInspection rig, int vertex)
        {
            CellPoint at = rig.located[vertex];
            return at.v == 0f && rig.rest.FirstJoint(at.cell) % rig.rest.jointsPerChain == 0;
        }

        private static UnityEngine.Vector3 Place(RigInspection rig, int joint) => rig.frame.ToMesh(rig.rest.joints[joint]);

        private static JointIndex[] AllJoints(RigInspection rig)
        {
            var all = new JointIndex[rig.rest.joints.Length];
            for (int joint = 0; joint < all.Length; joint++)
                all[joint] = rig.Joint(joint);
            return all;
        }

        private static string Count(int number, string one, string many) => number == 1 ? $"1 {one}" : $"{number} {many}";

        private static string Percent(float share) => (100f * share).ToString("0.#", CultureInfo.InvariantCulture) + " %";
    }
}
