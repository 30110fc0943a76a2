using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that move the selected joints along their own chains.</summary>
    internal static class SlideCommands
    {
        /// <summary>Least distance of a joint from its neighbour, as a share of the bone between both.</summary>
        public const float Gap = 0.02f;

        /// <summary>
        /// Slides joints by a distance towards the tip, mesh units; negative towards the root. Inner joints follow the bones and stop short
        /// of the joints beside them. Roots and tips move on the lines of the first and last bone.
        /// </summary>
        public static Proposal By(SkeletonDraft draft, JointIndex[] selected, float distance)
        {
            if (selected.Length == 0)
                return Proposal.Refuse(MoveCommands.NothingSelected);
            SkeletonDraft next = draft.Copy();
            var sliding = new HashSet<JointIndex>(selected);
            foreach (JointIndex joint in selected)
            {
                var path = new JointPath(draft.Chain(joint.chain));
                float low = Limit(path, sliding, joint, -1, distance), high = Limit(path, sliding, joint, 1, distance);
                next[joint] = path.At(Mathf.Clamp(path.DistanceOf(joint.joint) + distance, low, high));
            }

            return Proposal.Make(next);
        }

        // A neighbour that slides too makes way by the same distance; how far it gets, its own limit says.
        private static float Limit(JointPath path, HashSet<JointIndex> sliding, JointIndex joint, int side, float distance)
        {
            int beside = joint.joint + side;
            var neighbour = new JointIndex(joint.chain, beside);
            if (beside < 0 || beside >= path.JointCount)
                return side * float.PositiveInfinity;
            float here = path.DistanceOf(joint.joint), there = path.DistanceOf(beside);
            float limit = there + (here - there) * Gap;
            if (!sliding.Contains(neighbour) || distance * side <= 0f)
                return limit;
            float beyond = Limit(path, sliding, neighbour, side, distance);
            float moved = side > 0 ? Mathf.Min(there + distance, beyond) : Mathf.Max(there + distance, beyond);
            return moved + (here - there) * Gap;
        }
    }
}
