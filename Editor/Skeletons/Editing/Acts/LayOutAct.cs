using System;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Makes a skeleton out of nothing but the wing's mesh.</summary>
    internal static class LayOutAct
    {
        /// <summary>Hinge, axes and chains as the package lays them out for wings without a skeleton.</summary>
        /// <param name="surface">The wing; may be null.</param>
        /// <param name="side">Its side.</param>
        public static Proposal Make(SnapSurface surface, WingSide side)
        {
            if (surface == null)
                return Proposal.Refuse("There is no mesh to lay the skeleton out on.");
            WingSkeleton fitted = null;
            try
            {
                fitted = AutomaticSkeleton.Fit(surface.Wing, side);
                string fault = SkeletonDraft.Read(fitted, out SkeletonDraft draft);
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
