using System;
using Alate.Fitting;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Makes a skeleton out of nothing but the wing's mesh.</summary>
    internal static class LayOutCommand
    {
        /// <summary>Hinge, axes and chains by <see cref="SkeletonFitter"/>, with as many chains and joints as there are, else as it likes.</summary>
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
