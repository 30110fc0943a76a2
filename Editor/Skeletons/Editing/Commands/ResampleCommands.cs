using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Commands that lay joints out again along the chains.</summary>
    internal static class ResampleCommands
    {
        /// <summary>
        /// Spaces the joints of the chains with a selected joint, or of all where none is selected, evenly along them. Roots and tips stay.
        /// </summary>
        public static Proposal Evenly(SkeletonDraft draft, JointIndex[] selected)
        {
            var chains = new HashSet<int>(Array.ConvertAll(selected, joint => joint.chain));
            SkeletonDraft next = draft.Copy();
            for (int i = 0; i < draft.ChainCount; i++)
            {
                if (chains.Count == 0 || chains.Contains(i))
                    next.SetChain(i, new JointPath(draft.Chain(i)).Evenly(draft.JointsPerChain));
            }

            return Proposal.Make(next);
        }

        /// <summary>Lays out the fan with other counts: joints evenly along each chain, chains evenly from the first to the last.</summary>
        public static Proposal ToCounts(SkeletonDraft draft, int chains, int joints)
        {
            if (chains < WingSkeleton.MinChains || chains > WingSkeleton.MaxChains)
                return Proposal.Refuse($"A wing has {WingSkeleton.MinChains} to {WingSkeleton.MaxChains} chains, not {chains}.");
            if (joints < WingSkeleton.MinJoints || joints > WingSkeleton.MaxJoints)
                return Proposal.Refuse($"A chain has {WingSkeleton.MinJoints} to {WingSkeleton.MaxJoints} joints, not {joints}.");
            SkeletonDraft along = draft;
            if (joints != draft.JointsPerChain)
            {
                along = draft.Resized(draft.ChainCount, joints);
                for (int i = 0; i < draft.ChainCount; i++)
                    along.SetChain(i, new JointPath(draft.Chain(i)).Evenly(joints));
            }

            return Proposal.Make(chains == draft.ChainCount ? along.Copy() : Across(along, chains), Array.Empty<JointIndex>());
        }

        private static SkeletonDraft Across(SkeletonDraft draft, int chains)
        {
            SkeletonDraft next = draft.Resized(chains, draft.JointsPerChain);
            for (int i = 0; i < chains; i++)
            {
                float place = (float)i * (draft.ChainCount - 1) / (chains - 1);
                int before = Mathf.Min((int)place, Math.Max(draft.ChainCount - 2, 0)), behind = Math.Min(before + 1, draft.ChainCount - 1);
                for (int j = 0; j < draft.JointsPerChain; j++)
                    next[i, j] = Vector3.Lerp(draft[before, j], draft[behind, j], place - before);
            }

            return next;
        }
    }
}
