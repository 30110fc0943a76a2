using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Finds problems of an insect without baking; for the inspector and before baking.</summary>
    internal static class InsectCheck
    {
        /// <summary>Finds the first problem; none when all wings look right.</summary>
        /// <param name="insect">Whose wings.</param>
        /// <param name="skeletons">Those in use, which are checked once for all wings; null checks them now.</param>
        public static InsectProblem Find(InsectWings insect, AssetWatch<WingSkeleton, SkeletonValue> skeletons = null)
        {
            List<Wing> wings = insect.Wings;
            if (wings.Count == 0)
                return NoWings(insect);

            for (int w = 0; w < wings.Count; w++)
            {
                InsectProblem problem = Find(wings[w], w, skeletons);
                if (problem.IsProblem)
                    return problem;
            }

            return InsectProblem.None;
        }

        /// <summary>Finds the problem that keeps one wing from being baked.</summary>
        private static InsectProblem Find(Wing wing, int index, AssetWatch<WingSkeleton, SkeletonValue> skeletons)
        {
            if (wing == null || wing.Renderer == null)
            {
                return new InsectProblem(InsectState.NoRenderer, index,
                    "it has no renderer. Assign the MeshRenderer that draws it, or remove the wing from the list.");
            }

            string name = wing.Renderer.name;
            MeshFilter filter = FilterOf(wing);
            Mesh mesh = MeshOf(wing, filter);
            if (mesh == null)
            {
                return new InsectProblem(InsectState.NoMesh, index,
                    $"'{name}' has no MeshFilter with a mesh. Add one, or assign the renderer that has it.");
            }

            if (wing.Renderer.isPartOfStaticBatch)
            {
                return new InsectProblem(InsectState.StaticBatch, index,
                    $"'{name}' was merged by static batching. Turn off Batching Static on it.");
            }

            if (!mesh.isReadable)
            {
                return new InsectProblem(InsectState.MeshNotReadable, index,
                    $"mesh '{mesh.name}' of '{name}' is not readable. Turn on Read/Write in its import settings.");
            }

            if (wing.Part == WingPart.Submesh && (wing.Submesh < 0 || wing.Submesh >= mesh.subMeshCount))
            {
                return new InsectProblem(InsectState.NoSuchPart, index,
                    $"mesh '{mesh.name}' has no submesh {wing.Submesh}. Choose one from 0 to {mesh.subMeshCount - 1}.");
            }

            return Skeleton(wing, index, skeletons);
        }

        /// <summary>Authored mesh of a wing, also where its filter shows a living mesh or lost it; null where there is none.</summary>
        public static Mesh MeshOf(Wing wing, MeshFilter filter)
        {
            if (filter == null)
                return null;
            Mesh shown = LivingMeshes.SourceOf(filter.sharedMesh);
            return shown != null ? shown : wing.Authored;
        }

        /// <summary>Restores the authored mesh of a wing that came as a clone of a living one.</summary>
        public static void Repair(Wing wing)
        {
            MeshFilter filter = wing == null ? null : FilterOf(wing);
            Mesh mesh = wing == null ? null : MeshOf(wing, filter);
            if (mesh == null || LivingMeshes.LivesOn(filter))
                return;
            if (!ReferenceEquals(filter.sharedMesh, mesh))
                filter.sharedMesh = mesh;
            Material[] shown = wing.Renderer.sharedMaterials, authored = System.Array.ConvertAll(shown, SkinMaterials.SourceOf);
            if (!System.Linq.Enumerable.SequenceEqual(shown, authored))
                wing.Renderer.sharedMaterials = authored;
            wing.Authored = null;
        }

        /// <summary>The filter beside a wing's renderer; null where there is none.</summary>
        public static MeshFilter FilterOf(Wing wing) =>
            wing.Renderer != null && wing.Renderer.TryGetComponent(out MeshFilter filter) ? filter : null;

        private static InsectProblem NoWings(InsectWings insect)
        {
            List<SkinnedMeshRenderer> likely = WingFinder.FindSkinned(insect.transform);
            SkinnedMeshRenderer skinned = likely.Count > 0 ? likely[0] : insect.GetComponentInChildren<SkinnedMeshRenderer>(true);
            return skinned == null
                ? new InsectProblem(InsectState.NoWings, -1, "the list of wings is empty. Add them, or use Find Wings in the inspector.")
                : new InsectProblem(InsectState.SkinnedWings, -1,
                    $"the list of wings is empty, and '{skinned.name}' is a SkinnedMeshRenderer, which bones move. Convert it to a plain "
                    + "renderer in the inspector, then find the wings.");
        }

        /// <summary>First reason why a skeleton cannot be used, a sentence; null where there is none.</summary>
        public static string ProblemOf(WingSkeleton skeleton)
        {
            List<SkeletonProblem> problems = skeleton.Validate();
            return problems.Count == 0 ? null : problems[0].Message;
        }

        private static InsectProblem Skeleton(Wing wing, int index, AssetWatch<WingSkeleton, SkeletonValue> skeletons)
        {
            if (wing.Skeleton == null)
                return InsectProblem.None;
            string problem = skeletons == null ? ProblemOf(wing.Skeleton) : skeletons.Of(wing.Skeleton).Problem;
            return problem == null
                ? InsectProblem.None
                : new InsectProblem(InsectState.SkeletonInvalid, index,
                    $"skeleton '{wing.Skeleton.name}' cannot be used: {problem} Mend it in its inspector.");
        }
    }
}
