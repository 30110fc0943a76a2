using System.Collections.Generic;

namespace Alate.Editor
{
    /// <summary>Proposed content of a skeleton, or the reason why a command cannot make one. Nothing has been changed yet.</summary>
    internal readonly struct Proposal
    {
        private Proposal(SkeletonDraft draft, IReadOnlyList<JointIndex> selection, string refusal)
        {
            Draft = draft;
            Selection = selection;
            Refusal = refusal;
        }

        /// <summary>The new content; null where refused.</summary>
        public SkeletonDraft Draft { get; }

        /// <summary>The joints to select afterwards; null to leave the selection as it is.</summary>
        public IReadOnlyList<JointIndex> Selection { get; }

        /// <summary>Sentence for the user; null where there is a draft.</summary>
        public string Refusal { get; }

        public static Proposal Make(SkeletonDraft draft, IReadOnlyList<JointIndex> selection = null) =>
            new Proposal(draft, selection, null);

        public static Proposal Refuse(string why) => new Proposal(null, null, why);
    }
}
