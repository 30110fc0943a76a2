using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that move the selected joints.</summary>
    internal static class MoveCommands
    {
        public const string NothingSelected = "Select a joint first.";

        /// <summary>Moves joints by a vector of mesh space.</summary>
        public static Proposal By(SkeletonDraft draft, JointIndex[] selected, Vector3 delta)
        {
            if (selected.Length == 0)
                return Proposal.Refuse(NothingSelected);
            SkeletonDraft next = draft.Copy();
            foreach (JointIndex joint in selected)
                next[joint] += delta;
            return Proposal.Make(next);
        }

        /// <summary>Moves joints by a vector of mesh space, and then each to the closest point of the surface.</summary>
        public static Proposal OnSurface(SkeletonDraft draft, JointIndex[] selected, Vector3 delta, SnapSurface surface)
        {
            Proposal moved = By(draft, selected, delta);
            if (moved.Refusal != null)
                return moved;
            if (surface == null)
                return Proposal.Refuse("There is no mesh to snap to.");
            foreach (JointIndex joint in selected)
                moved.Draft[joint] = surface.ClosestPoint(moved.Draft[joint]);
            return moved;
        }
    }
}
