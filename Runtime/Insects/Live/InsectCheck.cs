using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>What can be said of an insect without baking anything; for the inspector and before baking.</summary>
    internal static class InsectCheck
    {
        /// <summary>The first problem; none when all wings look right.</summary>
        public static InsectProblem Find(InsectWings insect)
        {
            List<Wing> wings = insect.Wings;
            if (wings.Count == 0)
                return FindWithoutWings(insect);

            for (int w = 0; w < wings.Count; w++)
            {
                InsectProblem problem = Find(wings[w], w);
                if (problem.IsProblem)
                    return problem;
            }

            return InsectProblem.None;
        }

        private static InsectProblem FindWithoutWings(InsectWings insect)
        {
            List<SkinnedMeshRenderer> skinned = WingFinder.FindSkinned(insect.transform);
            return skinned.Count > 0
                ? new InsectProblem(InsectState.SkinnedWings, -1,
                    $"'{insect.name}': the wings are drawn by the SkinnedMeshRenderer '{skinned[0].name}'. Convert it to a plain renderer with Fix, or by SkinnedWingConversion.Convert.")
                : new InsectProblem(InsectState.NoWings, -1,
                    $"'{insect.name}' has no wings in its list. Add them, or use Find Wings in the inspector.");
        }

        /// <summary>What keeps one wing from being baked.</summary>
        public static InsectProblem Find(Wing wing, int index)
        {
            if (wing == null || wing.Renderer == null)
            {
                return new InsectProblem(InsectState.NoRenderer, index,
                    $"Wing {index} has no renderer. Assign the MeshRenderer that draws it, or remove the wing from the list.");
            }

            string name = wing.Renderer.name;
            MeshFilter filter = FilterOf(wing);
            Mesh mesh = MeshOf(wing, filter);
            if (mesh == null)
            {
                return new InsectProblem(InsectState.NoMesh, index,
                    $"Wing {index}: '{name}' has no MeshFilter with a mesh. Add one, or assign the renderer that has it.");
            }

            if (wing.Renderer.isPartOfStaticBatch)
            {
                return new InsectProblem(InsectState.StaticBatch, index,
                    $"Wing {index}: '{name}' was merged by static batching. Turn off Batching Static on it.");
            }

            if (!mesh.isReadable)
            {
                return new InsectProblem(InsectState.MeshNotReadable, index,
                    $"Wing {index}: mesh '{mesh.name}' of '{name}' is not readable. Turn on Read/Write in its import settings.");
            }

            if (wing.Part == WingPart.Submesh && (wing.Submesh < 0 || wing.Submesh >= mesh.subMeshCount))
            {
                return new InsectProblem(InsectState.NoSuchPart, index,
                    $"Wing {index}: mesh '{mesh.name}' has no submesh {wing.Submesh}, it has {mesh.subMeshCount}. Choose one from 0 on.");
            }

            return Skeleton(wing, index);
        }

        /// <summary>The authored mesh of a wing, also where its filter shows a living one or lost it; null where there is none.</summary>
        public static Mesh MeshOf(Wing wing, MeshFilter filter)
        {
            if (filter == null)
                return null;
            Mesh shown = LivingMeshes.SourceOf(filter.sharedMesh);
            return shown != null ? shown : wing.Authored;
        }

        /// <summary>Lets a wing show its authored mesh again where it came as a clone of a living one.</summary>
        public static void Heal(Wing wing)
        {
            MeshFilter filter = wing == null ? null : FilterOf(wing);
            Mesh mesh = wing == null ? null : MeshOf(wing, filter);
            if (mesh == null)
                return;
            if (!ReferenceEquals(filter.sharedMesh, mesh))
                filter.sharedMesh = mesh;
            wing.Authored = null;
        }

        /// <summary>The filter beside a wing's renderer; null where there is none.</summary>
        public static MeshFilter FilterOf(Wing wing) =>
            wing.Renderer != null && wing.Renderer.TryGetComponent(out MeshFilter filter) ? filter : null;

        private static InsectProblem Skeleton(Wing wing, int index)
        {
            if (wing.Skeleton == null)
                return InsectProblem.None;
            List<SkeletonProblem> problems = wing.Skeleton.Validate();
            return problems.Count == 0
                ? InsectProblem.None
                : new InsectProblem(InsectState.SkeletonInvalid, index,
                    $"Wing {index}: skeleton '{wing.Skeleton.name}' cannot be used: {problems[0].Message} Mend it in its inspector.");
        }
    }
}
