using System;
using System.Collections.Generic;
using Alate.Fitting;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Skeleton under edit, with its selection. Every change passes through here: it is checked, recorded for undo and only then made, so
    /// that no command can leave a skeleton with invalid counts or unusable positions.
    /// </summary>
    internal sealed class SkeletonEditing
    {
        private readonly IUndoRecorder m_Undo;

        public SkeletonEditing(JointSelection selection, IUndoRecorder undo)
        {
            Selection = selection;
            m_Undo = undo;
        }

        public WingSkeleton Skeleton => Selection.Skeleton;

        public JointSelection Selection { get; }

        /// <summary>Matrix from the skeleton's mesh space to the world.</summary>
        public Matrix4x4 LocalToWorld { get; set; } = Matrix4x4.identity;

        /// <summary>The wing's mesh, to snap to; may be null.</summary>
        public SnapSurface Surface { get; set; }

        /// <summary>Settings for laying the skeleton out again.</summary>
        public SkeletonFitSettings Known { get; set; } = SkeletonFitSettings.Default;

        /// <summary>Skeleton of the other wing; null where there is none.</summary>
        public SkeletonTwin Twin { get; set; }

        /// <summary>Reason why the skeleton may not be changed, one sentence; null where it may.</summary>
        public string Lock { get; set; }

        /// <summary>True where commands also change the twin.</summary>
        public bool IsSymmetric { get; set; }

        /// <summary>Returns true where a skeleton follows this one.</summary>
        public bool Leads(WingSkeleton other) => IsSymmetric && Twin != null && Twin.Skeleton == other;

        /// <summary>Present content of the skeleton and its twin.</summary>
        /// <returns>Null, or why the skeleton cannot be worked on.</returns>
        public string Start(out EditStart start)
        {
            SkeletonDraft twin = null;
            if (Twin != null)
                SkeletonDraft.Read(Twin.Skeleton, out twin);
            string fault = SkeletonDraft.Read(Skeleton, out SkeletonDraft own);
            start = new EditStart(own, twin);
            return fault;
        }

        /// <summary>Runs a command on a skeleton with complete chains.</summary>
        public EditOutcome Do(string undoName, Func<SkeletonDraft, JointIndex[], Proposal> make)
        {
            string fault = Start(out EditStart start);
            return fault != null ? EditOutcome.Refused(fault) : Commit(undoName, start, make(start.Own, Selection.Living()));
        }

        /// <summary>Checks, records and makes a change.</summary>
        /// <param name="undoName">Name in the undo menu.</param>
        /// <param name="start">What was there when the command began.</param>
        /// <param name="proposal">What the skeleton shall become.</param>
        public EditOutcome Commit(string undoName, in EditStart start, Proposal proposal)
        {
            string refusal = Lock ?? proposal.Refusal;
            if (refusal != null)
                return EditOutcome.Refused(refusal);
            SkeletonDraft after = proposal.Draft.Copy();
            KeepHingeOnRoot(start.Own, after);
            string fault = after.FindFault();
            if (fault != null)
                return EditOutcome.Refused(fault);
            Proposal twin = IsSymmetric && Twin != null ? Twin.Follow(start, after) : default;
            fault = twin.Refusal ?? twin.Draft?.FindFault();
            if (fault != null)
                return EditOutcome.Refused(fault);

            m_Undo.Begin(undoName);
            Write(Skeleton, after);
            if (twin.Draft != null)
                Write(Twin.Skeleton, twin.Draft);
            if (proposal.Selection != null)
                SetSelection(proposal.Selection);
            m_Undo.End();
            return EditOutcome.Success;
        }

        /// <summary>Selects joints, undoable.</summary>
        public void Select(IReadOnlyList<JointIndex> joints)
        {
            m_Undo.Begin("Select Joints");
            SetSelection(joints);
            m_Undo.End();
        }

        /// <summary>Makes the twin the mirror image of this skeleton.</summary>
        public EditOutcome MirrorOntoTwin()
        {
            if (Twin == null)
                return EditOutcome.Refused("There is no wing on the other side to mirror onto.");
            string fault = SkeletonDraft.Read(Skeleton, out SkeletonDraft draft);
            fault = Twin.Lock ?? fault;
            SkeletonDraft image = fault == null ? SkeletonMirror.Reflect(draft, Twin.ToTwin) : null;
            fault ??= image.FindFault();
            if (fault != null)
                return EditOutcome.Refused(fault);
            m_Undo.Begin("Mirror Skeleton");
            Write(Twin.Skeleton, image);
            m_Undo.End();
            return EditOutcome.Success;
        }

        private void Write(WingSkeleton skeleton, SkeletonDraft draft)
        {
            SkeletonDraft.Read(skeleton, out SkeletonDraft present);
            if (draft.IsSame(present))
                return;
            m_Undo.Record(skeleton);
            draft.WriteTo(skeleton);
            m_Undo.Changed(skeleton);
        }

        private void SetSelection(IReadOnlyList<JointIndex> joints)
        {
            if (Selection.IsSame(joints))
                return;
            m_Undo.Record(Selection);
            Selection.Set(joints);
        }

        // The wing frame begins at the hinge, which by default is the first root: where it was, it stays, unless the command moved it
        // itself.
        private static void KeepHingeOnRoot(SkeletonDraft before, SkeletonDraft after)
        {
            if (before != null && before.Hinge.Equals(before[0, 0]) && after.Hinge.Equals(before.Hinge))
                after.Hinge = after[0, 0];
        }
    }
}
