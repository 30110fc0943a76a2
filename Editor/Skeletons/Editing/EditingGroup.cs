using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>The skeletons that are edited together, one of them active: those of all selected insects.</summary>
    internal sealed class EditingGroup
    {
        private readonly List<SkeletonEditing> m_All;
        private readonly IUndoRecorder m_Undo;
        private SkeletonEditing m_Active;

        public EditingGroup(IEnumerable<SkeletonEditing> all, IUndoRecorder undo)
        {
            m_All = new List<SkeletonEditing>(all);
            m_Undo = undo;
        }

        public IReadOnlyList<SkeletonEditing> All => m_All;

        /// <summary>
        /// Skeleton whose counts and problems are shown, and that commands change when nothing is selected; null where there is none.
        /// </summary>
        public SkeletonEditing Active
        {
            get => m_Active ?? (m_All.Count > 0 ? m_All[0] : null);
            set => m_Active = value;
        }

        /// <summary>Number of selected joints of all skeletons.</summary>
        public int SelectedCount
        {
            get
            {
                int count = 0;
                foreach (SkeletonEditing editing in m_All)
                    count += editing.Selection.Living().Length;
                return count;
            }
        }

        /// <summary>
        /// Skeletons that commands and drags change: all with a selected joint, or the active one where there is none. Of a symmetric pair
        /// only one, the active one if possible: the other follows.
        /// </summary>
        public List<SkeletonEditing> Acting()
        {
            var acting = new List<SkeletonEditing>();
            if (Active == null)
                return acting;
            bool any = SelectedCount > 0;
            var order = new List<SkeletonEditing> { Active };
            order.AddRange(m_All.FindAll(editing => editing != Active));
            foreach (SkeletonEditing editing in order)
            {
                bool chosen = any ? editing.Selection.Living().Length > 0 : editing == Active;
                if (chosen && !acting.Exists(other => other.Leads(editing.Skeleton)))
                    acting.Add(editing);
            }

            return acting;
        }

        /// <summary>Runs a command on the <see cref="Acting"/> skeletons, in one step of undo.</summary>
        /// <returns>Why one of them refused, where one did.</returns>
        public EditOutcome Do(EditCommand command)
        {
            if (Active == null)
                return EditOutcome.Refused("There is no skeleton to edit.");
            EditOutcome outcome = EditOutcome.Success;
            m_Undo.Begin(command.Name);
            foreach (SkeletonEditing editing in Acting())
            {
                EditOutcome own = command.Run(editing);
                outcome = outcome.Done ? own : outcome;
            }

            m_Undo.End();
            return outcome;
        }

        /// <summary>Selects joints of one skeleton and, unless adding, nothing else; null to select nothing.</summary>
        public void Select(SkeletonEditing chosen, IReadOnlyList<JointIndex> joints, bool adds) =>
            SelectEach(editing => editing == chosen ? joints : Array.Empty<JointIndex>(), adds);

        /// <summary>Selects the joints seen within a rectangle.</summary>
        public void SelectInside(ScreenProjection project, Rect rectangle, bool adds) =>
            SelectEach(editing => JointPicking.Inside(editing, project, rectangle), adds);

        /// <summary>Selects all joints of all skeletons.</summary>
        public void SelectAll() => SelectEach(editing => new List<JointIndex>(JointPicking.All(editing.Skeleton)), false);

        /// <summary>The joint of any of the skeletons seen closest to a pixel.</summary>
        public bool TryNearest(ScreenProjection project, Vector2 pixel, float radius, out SkeletonEditing found, out JointIndex joint)
        {
            found = null;
            joint = default;
            float least = float.PositiveInfinity;
            foreach (SkeletonEditing editing in m_All)
            {
                if (!JointPicking.TryNearest(editing, project, pixel, radius, out JointIndex own, out float distance)
                    || !(distance < least))
                {
                    continue;
                }
                least = distance;
                found = editing;
                joint = own;
            }

            return found != null;
        }

        private void SelectEach(Func<SkeletonEditing, IReadOnlyList<JointIndex>> choose, bool adds)
        {
            m_Undo.Begin("Select Joints");
            foreach (SkeletonEditing editing in m_All)
            {
                var joints = new SortedSet<JointIndex>(choose(editing));
                if (adds)
                    joints.UnionWith(editing.Selection.Living());
                editing.Select(new List<JointIndex>(joints));
            }

            m_Undo.End();
        }
    }
}
