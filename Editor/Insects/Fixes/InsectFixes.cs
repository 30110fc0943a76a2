using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Table of the fixes for each state.</summary>
    internal static class InsectFixes
    {
        private static readonly InsectFix[] s_None = new InsectFix[0];
        private static readonly InsectFix s_FindWings = new FindWingsFix();
        private static readonly InsectFix s_RemoveWing = new RemoveWingFix();
        private static readonly InsectFix s_ReadableMesh = new ReadableMeshFix();
        private static readonly InsectFix s_StaticBatching = new StaticBatchingFix();
        private static readonly InsectFix s_SkinnedWings = new SkinnedWingsFix(AssetPath.Ask);
        private static readonly InsectFix s_LayOutSkeletons = new LayOutSkeletonFix(LayOutSkeletonFix.Fit, AssetPath.Ask);
        private static readonly InsectFix s_OpenSkeleton = new OpenSkeletonFix();

        /// <summary>Fixes for a problem, the best one first; none where only the user can know the remedy.</summary>
        public static IReadOnlyList<InsectFix> For(InsectWings insect, in InsectProblem problem)
        {
            switch (problem.State)
            {
                case InsectState.NoWings:
                    return new[] { s_FindWings };
                case InsectState.SkinnedWings:
                    return new[] { s_SkinnedWings };
                case InsectState.NoRenderer:
                case InsectState.NoMesh:
                    return new[] { s_RemoveWing };
                case InsectState.MeshNotReadable:
                    return new[] { s_ReadableMesh };
                case InsectState.StaticBatch:
                    return new[] { s_StaticBatching };
                case InsectState.WingsOverlap:
                    return WingList.HasTwin(insect.Wings, problem.Wing) ? new[] { s_RemoveWing } : s_None;
                case InsectState.SkeletonInvalid:
                    return new[] { s_OpenSkeleton, s_LayOutSkeletons };
                case InsectState.SkeletonDoesNotFit:
                    return new[] { s_LayOutSkeletons, s_OpenSkeleton };
                default:
                    return s_None;
            }
        }
    }
}
