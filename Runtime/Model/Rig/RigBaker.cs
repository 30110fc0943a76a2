using System;
using System.Collections.Generic;
using Unity.Mathematics;

namespace Alate
{
    /// <summary>Makes the content of a rig from a skeleton and a surface, step by step.</summary>
    internal static class RigBaker
    {
        public static RigContent Bake(WingSkeleton skeleton, SurfaceMesh surface, in WingRigSettings settings)
        {
            CheckSkeleton(skeleton);
            SurfaceCheck.Run(surface);
            if (settings.patchCount < 0)
                throw new ArgumentOutOfRangeException(nameof(settings), settings.patchCount, "The number of patches cannot be negative.");

            WingFrame frame = WingFraming.Frame(skeleton, surface);
            float3[] points = WingFraming.ToWing(frame, surface);
            var rest = new RestSkeleton(skeleton, frame);
            var cells = new CellMap(rest);
            var triangles = new SurfaceTriangles(points, surface.triangles);
            CellPoint[] centres = cells.Locate(triangles.centres.ToArray());
            FitCheck.Run(SurfaceCheck.Name(surface), rest, triangles, centres);

            CellPoint[] weights = cells.Locate(points);
            var chords = new SpanChords(points, triangles);
            float[] added = AddedMasses.OfJoints(rest, chords, triangles, weights);
            float[] masses = JointMasses.OfJoints(rest, triangles, weights);
            float[] inertias = JointMasses.Inertias(rest, masses);
            var beams = new BeamHinges(skeleton, rest, masses, inertias);
            float[] veins = VeinFactors.Of(skeleton, rest, out bool hasVeins);
            return new RigContent
            {
                frame = frame,
                rest = rest,
                triangleCount = triangles.Count,
                area = (float)triangles.Area,
                jointMasses = masses,
                addedMasses = added,
                addedInertias = JointMasses.Inertias(rest, added),
                jointInertias = beams.inertias,
                beams = beams,
                veinFactors = veins,
                hasVeins = hasVeins,
                leverDamping = JointMasses.LeverDamping(rest),
                springs = SpringNetwork.Make(rest),
                strips = new StripNetwork(rest),
                patches = new PatchLayout(rest, cells, triangles, centres, chords, settings.patchCount),
                coarsePatches = new PatchLayout(rest, cells, triangles, centres, chords, WingRigSettings.CoarsePatches),
                influences = new VertexInfluences(rest, weights),
                skin = new SkinLayout(rest, frame, weights, surface, SurfaceNormals.Make(surface, frame), settings.smallerVertices),
            };
        }

        private static void CheckSkeleton(WingSkeleton skeleton)
        {
            if (skeleton == null)
                throw new ArgumentNullException(nameof(skeleton));
            List<SkeletonProblem> problems = skeleton.Validate();
            if (problems.Count > 0)
            {
                string name = string.IsNullOrEmpty(skeleton.name) ? "The skeleton" : $"Skeleton '{skeleton.name}'";
                throw new ArgumentException($"{name} cannot be used: {problems[0].Message}");
            }
        }
    }
}
