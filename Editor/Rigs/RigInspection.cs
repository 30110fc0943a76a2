using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate.Editor
{
    /// <summary>
    /// Contents that baking would make of a skeleton and a mesh: the joints that move each vertex, the distribution of the mass, the
    /// patches that meet the air. Uses the steps of <see cref="RigBaker"/>, but in managed memory, and also takes a skeleton that does not
    /// fit well.
    /// </summary>
    internal sealed class RigInspection
    {
        public readonly WingFrame frame;
        public readonly RestSkeleton rest;

        /// <summary>Vertices in the wing frame, wing lengths.</summary>
        public readonly float3[] points;

        /// <summary>[vertex] Cell, coordinates there and distance from the fan of joints.</summary>
        public readonly CellPoint[] located;

        /// <summary>The triangles that count, each place once.</summary>
        public readonly SurfaceTriangles triangles;

        /// <summary>[triangle] Patch of the triangle.</summary>
        public readonly int[] patches;

        /// <summary>[joint] Share of the wing's mass; sum 1.</summary>
        public readonly float[] masses;

        private RigInspection(WingSkeleton skeleton, SurfaceMesh surface, int patchCount)
        {
            Surface = surface;
            frame = WingFraming.Frame(skeleton, surface);
            points = WingFraming.ToWing(frame, surface);
            rest = new RestSkeleton(skeleton, frame);
            triangles = new SurfaceTriangles(points, surface.triangles);
            if (triangles.Count == 0)
                throw new ArgumentException($"{SurfaceCheck.Name(surface)} has no triangle with an area.");
            var map = new CellMap(rest);
            located = map.Locate(points);
            CellPoint[] centres = map.Locate(triangles.centres.ToArray());
            Misfit = FindMisfit(SurfaceCheck.Name(surface), centres);
            masses = JointMasses.OfJoints(rest, triangles, located);
            patches = patchCount == 0 || patchCount >= triangles.Count
                ? PatchClusters.OnePerTriangle(rest, centres, out int[] firsts)
                : PatchClusters.Make(rest, triangles, centres, patchCount, out firsts);
            PatchCount = firsts[rest.CellCount];
        }

        /// <summary>The inspected surface.</summary>
        public SurfaceMesh Surface { get; }

        /// <summary>Number of patches in use.</summary>
        public int PatchCount { get; }

        /// <summary>Reason why no rig can be baked although skeleton and mesh are each sound; null where one can.</summary>
        public string Misfit { get; }

        /// <summary>Inspects a skeleton and a surface; null where there is nothing to show.</summary>
        /// <param name="skeleton">The skeleton.</param>
        /// <param name="surface">The wing's triangles, in the skeleton's space.</param>
        /// <param name="patchCount">As in <see cref="WingRigSettings"/>.</param>
        /// <param name="refusal">Why there is nothing to see, one sentence.</param>
        public static RigInspection TryMake(WingSkeleton skeleton, SurfaceMesh surface, int patchCount, out string refusal)
        {
            refusal = null;
            List<SkeletonProblem> problems = skeleton.Validate();
            if (problems.Count > 0)
            {
                refusal = problems[0].Message;
                return null;
            }

            try
            {
                SurfaceCheck.Run(surface);
                return new RigInspection(skeleton, surface, patchCount);
            }
            catch (ArgumentException refused)
            {
                refusal = refused.Message;
                return null;
            }
        }

        /// <summary>Weight of some joints together at a vertex, 0 to 1.</summary>
        public float Weight(int vertex, IReadOnlyCollection<JointIndex> joints)
        {
            float sum = 0f;
            for (int corner = 0; corner < 4; corner++)
            {
                JointIndex joint = Joint(CornerJoint(located[vertex].cell, corner));
                foreach (JointIndex wanted in joints)
                    sum += wanted == joint ? located[vertex].Weights[corner] : 0f;
            }

            return math.min(sum, 1f);
        }

        /// <summary>A quantity of the joints at a vertex, by its weights.</summary>
        public float Blend(int vertex, float[] perJoint)
        {
            float4 weights = located[vertex].Weights;
            int cell = located[vertex].cell;
            return weights.x * perJoint[CornerJoint(cell, 0)] + weights.y * perJoint[CornerJoint(cell, 1)]
                + weights.z * perJoint[CornerJoint(cell, 2)] + weights.w * perJoint[CornerJoint(cell, 3)];
        }

        /// <summary>[joint] δ of Eq. 2 as a phase, λπρ + μπσ, radians.</summary>
        public float[] Delays(in WingParameters parameters)
        {
            float[] delays = new float[rest.joints.Length];
            for (int joint = 0; joint < delays.Length; joint++)
            {
                JointIndex index = Joint(joint);
                delays[joint] = math.PI
                    * (parameters.chordDelay * rest.chainRatio[index.chain] + parameters.spanDelay * rest.jointRatio[index.joint]);
            }

            return delays;
        }

        /// <summary>The joint that moves a vertex most.</summary>
        public JointIndex Strongest(int vertex)
        {
            float4 weights = located[vertex].Weights;
            int best = 0;
            for (int corner = 1; corner < 4; corner++)
                best = weights[corner] > weights[best] ? corner : best;
            return Joint(CornerJoint(located[vertex].cell, best));
        }

        /// <summary>Chain and place of a joint index.</summary>
        public JointIndex Joint(int joint) => new JointIndex(joint / rest.jointsPerChain, joint % rest.jointsPerChain);

        /// <summary>Distance of a vertex from the fan of joints, in plan and in height, wing lengths.</summary>
        public float Distance(int vertex)
        {
            CellPoint at = located[vertex];
            float4 heights = default;
            for (int corner = 0; corner < 4; corner++)
                heights[corner] = rest.joints[CornerJoint(at.cell, corner)].y;
            float height = points[vertex].y - math.dot(at.Weights, heights);
            return math.sqrt(at.distance * at.distance + height * height);
        }

        // In the order of CellPoint.Weights.
        private int CornerJoint(int cell, int corner) =>
            rest.FirstJoint(cell) + (corner & 1) + (corner >> 1) * rest.jointsPerChain;

        private string FindMisfit(string name, CellPoint[] centres)
        {
            try
            {
                FitCheck.Run(name, rest, triangles, centres);
                return null;
            }
            catch (ArgumentException misfit)
            {
                return misfit.Message;
            }
        }
    }
}
