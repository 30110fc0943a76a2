using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that add, remove and reorder whole chains.</summary>
    internal static class ChainCommands
    {
        /// <summary>Distance of a new chain beyond the first or last one, in distances to its neighbour.</summary>
        private const float k_Beyond = 0.5f;

        /// <summary>
        /// Adds a chain halfway to the next one behind each chain with a selected joint; behind the last chain, beyond it.
        /// </summary>
        public static Proposal AddBehind(SkeletonDraft draft, JointIndex[] selected) =>
            Add(draft, Chains(selected), 1);

        /// <summary>Adds a chain before each chain with a selected joint; the one before the first becomes the principal chain.</summary>
        public static Proposal AddBefore(SkeletonDraft draft, JointIndex[] selected) =>
            Add(draft, Chains(selected), 0);

        /// <summary>Removes the chains with a selected joint.</summary>
        public static Proposal Remove(SkeletonDraft draft, JointIndex[] selected)
        {
            SortedSet<int> chains = Chains(selected);
            if (chains.Count == 0)
                return Proposal.Refuse("Select a joint of the chain to remove.");
            int left = draft.ChainCount - chains.Count;
            if (left < WingSkeleton.MinChains)
                return Proposal.Refuse($"{left} chains would be left; a wing needs at least {WingSkeleton.MinChains}.");
            SkeletonDraft next = draft.Resized(left, draft.JointsPerChain);
            for (int from = 0, to = 0; from < draft.ChainCount; from++)
            {
                if (!chains.Contains(from))
                    next.SetChain(to++, draft.Chain(from), draft.Measured(from));
            }

            return Proposal.Make(next, Array.Empty<JointIndex>());
        }

        /// <summary>Reverses the order of the chains, so that the last one becomes the leading edge.</summary>
        public static Proposal Reverse(SkeletonDraft draft, JointIndex[] selected)
        {
            SkeletonDraft next = draft.Copy();
            for (int i = 0; i < draft.ChainCount; i++)
                next.SetChain(draft.ChainCount - 1 - i, draft.Chain(i), draft.Measured(i));
            JointIndex[] turned = Array.ConvertAll(selected, s => new JointIndex(draft.ChainCount - 1 - s.chain, s.joint));
            return Proposal.Make(next, turned);
        }

        private static Proposal Add(SkeletonDraft draft, SortedSet<int> beside, int side)
        {
            if (beside.Count == 0)
                return Proposal.Refuse("Select a joint of the chain to add one beside.");
            if (draft.ChainCount < 2)
                return Proposal.Refuse("There must be two chains before one can be added: mend the skeleton first.");
            int count = draft.ChainCount + beside.Count;
            if (count > WingSkeleton.MaxChains)
                return Proposal.Refuse($"There would be {count} chains; a wing has at most {WingSkeleton.MaxChains}.");
            SkeletonDraft next = draft.Resized(count, draft.JointsPerChain);
            var added = new List<JointIndex>();
            for (int from = 0, to = 0; from < draft.ChainCount; from++)
            {
                if (side == 0 && beside.Contains(from))
                    Insert(draft, from - 1, next, to++, added);
                next.SetChain(to++, draft.Chain(from), draft.Measured(from));
                if (side == 1 && beside.Contains(from))
                    Insert(draft, from, next, to++, added);
            }

            return Proposal.Make(next, added);
        }

        // Between a chain and the next one; before the first and behind the last, beyond it.
        private static void Insert(SkeletonDraft draft, int before, SkeletonDraft next, int at, List<JointIndex> added)
        {
            int first = Mathf.Clamp(before, 0, draft.ChainCount - 2);
            float share = before < first ? -k_Beyond : before > first ? 1f + k_Beyond : 0.5f;
            for (int j = 0; j < draft.JointsPerChain; j++)
            {
                next[at, j] = Vector3.LerpUnclamped(draft[first, j], draft[first + 1, j], share);
                added.Add(new JointIndex(at, j));
            }
        }

        private static SortedSet<int> Chains(JointIndex[] selected)
        {
            var chains = new SortedSet<int>();
            foreach (JointIndex joint in selected)
                chains.Add(joint.chain);
            return chains;
        }
    }
}
