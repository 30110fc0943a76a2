using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Makes complete chains of finite joints from a skeleton without them.</summary>
    internal static class MendCommand
    {
        /// <summary>
        /// Drops chains with fewer than two usable joints, gives the others as many joints as most of them have, and brings both counts
        /// into their range. Chains that are complete keep their joints.
        /// </summary>
        public static Proposal Make(WingSkeleton skeleton)
        {
            List<JointChain> chains = UsableChains(skeleton);
            if (chains.Count < 2)
                return Proposal.Refuse("Fewer than two chains have two usable joints; that is too little to mend.");
            int joints = Mathf.Clamp(UsualLength(chains), WingSkeleton.MinJoints, WingSkeleton.MaxJoints);
            SkeletonDraft draft = new SkeletonDraft(chains.Count, joints).TakeFrame(skeleton);
            for (int i = 0; i < chains.Count; i++)
            {
                draft.SetChain(
                    i, chains[i].Length == joints ? chains[i].joints : new JointPath(chains[i].joints).Evenly(joints), chains[i]);
            }
            if (!SkeletonDraft.IsUsable(draft.Hinge))
                draft.Hinge = draft[0, 0];
            if (!WingAxes.TryMake(draft.SpanAxis, draft.UpAxis, out float3x3 _))
            {
                draft.SpanAxis = Vector3.right;
                draft.UpAxis = Vector3.up;
                draft = FrameCommands.FitAxes(draft).Draft ?? draft;
            }

            int count = Mathf.Clamp(chains.Count, WingSkeleton.MinChains, WingSkeleton.MaxChains);
            return count == chains.Count
                ? Proposal.Make(draft, Array.Empty<JointIndex>())
                : ResampleCommands.ToCounts(draft, count, joints);
        }

        private static List<JointChain> UsableChains(WingSkeleton skeleton)
        {
            var chains = new List<JointChain>();
            foreach (JointChain chain in skeleton.Chains)
            {
                Vector3[] usable = Array.FindAll(chain.joints ?? Array.Empty<Vector3>(), SkeletonDraft.IsUsable);
                JointChain kept = chain;
                kept.joints = usable.Length < 2 || usable.Length == chain.Length ? usable : new JointPath(usable).Evenly(chain.Length);
                if (usable.Length >= 2)
                    chains.Add(kept);
            }

            return chains;
        }

        private static int UsualLength(List<JointChain> chains)
        {
            int usual = 0, most = 0;
            foreach (JointChain candidate in chains)
            {
                int same = chains.FindAll(chain => chain.Length == candidate.Length).Count;
                if (same > most || (same == most && candidate.Length > usual))
                {
                    most = same;
                    usual = candidate.Length;
                }
            }

            return usual;
        }
    }
}
