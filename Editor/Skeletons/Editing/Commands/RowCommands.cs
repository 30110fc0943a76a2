using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Commands that add and remove joints in all chains at once, so that the chains keep equal counts. A row is one joint of each chain.
    /// </summary>
    internal static class RowCommands
    {
        /// <summary>
        /// Adds a joint to every chain, in the middle of the bone beyond each row with a selected joint; at the tips, of the bone before
        /// them.
        /// </summary>
        public static Proposal Add(SkeletonDraft draft, JointIndex[] selected)
        {
            if (selected.Length == 0)
                return Proposal.Refuse("Select a joint of the row to add one beyond.");
            if (draft.JointsPerChain < 2)
                return Proposal.Refuse("There must be two joints in a chain before one can be added: mend the skeleton first.");
            var bones = new SortedSet<int>();
            foreach (JointIndex joint in selected)
                bones.Add(Math.Min(joint.joint, draft.JointsPerChain - 2));
            int count = draft.JointsPerChain + bones.Count;
            if (count > WingSkeleton.MaxJoints)
                return Proposal.Refuse($"There would be {count} joints in a chain; it has at most {WingSkeleton.MaxJoints}.");

            SkeletonDraft next = draft.Resized(draft.ChainCount, count);
            var added = new List<JointIndex>();
            for (int i = 0; i < draft.ChainCount; i++)
            {
                for (int from = 0, to = 0; from < draft.JointsPerChain; from++)
                {
                    next[i, to++] = draft[i, from];
                    if (!bones.Contains(from))
                        continue;
                    added.Add(new JointIndex(i, to));
                    next[i, to++] = Vector3.Lerp(draft[i, from], draft[i, from + 1], 0.5f);
                }
            }

            return Proposal.Make(next, added);
        }

        /// <summary>Removes the rows with a selected joint. The roots stay, because they hold the wing.</summary>
        public static Proposal Remove(SkeletonDraft draft, JointIndex[] selected)
        {
            var rows = new SortedSet<int>();
            foreach (JointIndex joint in selected)
                rows.Add(joint.joint);
            if (rows.Count == 0)
                return Proposal.Refuse("Select a joint of the row to remove.");
            if (rows.Contains(0))
                return Proposal.Refuse("The roots cannot be removed; select joints farther out.");
            int left = draft.JointsPerChain - rows.Count;
            if (left < WingSkeleton.MinJoints)
                return Proposal.Refuse($"{left} joints would be left in a chain; it needs at least {WingSkeleton.MinJoints}.");

            SkeletonDraft next = draft.Resized(draft.ChainCount, left);
            for (int i = 0; i < draft.ChainCount; i++)
            {
                for (int from = 0, to = 0; from < draft.JointsPerChain; from++)
                {
                    if (!rows.Contains(from))
                        next[i, to++] = draft[i, from];
                }
            }

            return Proposal.Make(next, Array.Empty<JointIndex>());
        }
    }
}
