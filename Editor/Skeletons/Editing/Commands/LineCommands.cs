using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that smooth kinks in chains.</summary>
    internal static class LineCommands
    {
        /// <summary>
        /// Puts joints on a straight line, at the same shares of the way: in each chain with three or more selected joints those
        /// from the first to the last selected one; in chains with fewer, all. Without a selection, all chains.
        /// </summary>
        public static Proposal Straighten(SkeletonDraft draft, JointIndex[] selected)
        {
            SkeletonDraft next = draft.Copy();
            for (int i = 0; i < draft.ChainCount; i++)
            {
                JointIndex[] own = Array.FindAll(selected, joint => joint.chain == i);
                if (own.Length == 0 && selected.Length > 0)
                    continue;
                bool part = own.Length >= 3;
                Straighten(draft, next, i, part ? own[0].joint : 0, part ? own[own.Length - 1].joint : draft.JointsPerChain - 1);
            }

            return Proposal.Make(next);
        }

        /// <summary>
        /// Moves each selected joint, or all where none is selected, half way to the mean of the joints beside it along and across the
        /// chains. Roots and tips stay, for they lie on the outline.
        /// </summary>
        public static Proposal Smooth(SkeletonDraft draft, JointIndex[] selected)
        {
            SkeletonDraft next = draft.Copy();
            var chosen = new HashSet<JointIndex>(selected);
            bool moved = false;
            for (int i = 0; i < draft.ChainCount; i++)
            {
                for (int j = 1; j < draft.JointsPerChain - 1; j++)
                {
                    if (chosen.Count > 0 && !chosen.Contains(new JointIndex(i, j)))
                        continue;
                    moved = true;
                    next[i, j] = Vector3.Lerp(draft[i, j], Around(draft, i, j), 0.5f);
                }
            }

            return moved ? Proposal.Make(next) : Proposal.Refuse("Roots and tips are not smoothed; select joints between them.");
        }

        private static void Straighten(SkeletonDraft draft, SkeletonDraft next, int chain, int first, int last)
        {
            var path = new JointPath(draft.Chain(chain));
            float start = path.DistanceOf(first), length = path.DistanceOf(last) - start;
            for (int j = first + 1; j < last; j++)
            {
                float share = length > 0f ? (path.DistanceOf(j) - start) / length : (float)(j - first) / (last - first);
                next[chain, j] = Vector3.Lerp(draft[chain, first], draft[chain, last], share);
            }
        }

        // The first and last chain have a neighbour on one side only, which would pull them inwards: for them, along the chain alone.
        private static Vector3 Around(SkeletonDraft draft, int chain, int joint)
        {
            Vector3 along = 0.5f * (draft[chain, joint - 1] + draft[chain, joint + 1]);
            if (chain == 0 || chain == draft.ChainCount - 1)
                return along;
            return 0.5f * along + 0.25f * (draft[chain - 1, joint] + draft[chain + 1, joint]);
        }
    }
}
