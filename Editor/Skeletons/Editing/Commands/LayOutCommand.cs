using System;
using Alate.Fitting;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Lays out a skeleton from the wing's mesh alone.</summary>
    internal static class LayOutCommand
    {
        /// <summary>
        /// Fits hinge, axes and chains by <see cref="SkeletonFitter"/>, with the present numbers of chains and joints where they are valid,
        /// else with its defaults.
        /// </summary>
        /// <param name="present">The skeleton as it is.</param>
        /// <param name="surface">The wing; may be null.</param>
        /// <param name="known">What is known of the insect around it.</param>
        public static Proposal Make(WingSkeleton present, SnapSurface surface, SkeletonFitSettings known)
        {
            if (surface == null)
                return Proposal.Refuse("There is no mesh to lay the skeleton out on.");
            if (SkeletonDraft.Read(present, out SkeletonDraft draft) == null && draft.FindFault() == null)
            {
                known.chains = draft.ChainCount;
                known.jointsPerChain = draft.JointsPerChain;
            }

            WingSkeleton fitted = null;
            try
            {
                fitted = SkeletonFitter.Fit(surface.Wing, known).Skeleton;
                string fault = SkeletonDraft.Read(fitted, out draft);
                return fault == null ? Proposal.Make(draft, Array.Empty<JointIndex>()) : Proposal.Refuse(fault);
            }
            catch (ArgumentException refused)
            {
                return Proposal.Refuse(refused.Message);
            }
            finally
            {
                if (fitted != null)
                    Object.DestroyImmediate(fitted);
            }
        }
    }
}
