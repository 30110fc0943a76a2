using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// State of an editing session: the selections, the mouse's action, the settings of the panel, and the overlays of the wings.
    /// Independent of windows. Dispose it.
    /// </summary>
    internal sealed class SkeletonSession : IDisposable
    {
        private readonly List<SkeletonTarget> m_Targets;
        private readonly Dictionary<SkeletonEditing, SkeletonTarget> m_TargetOf = new Dictionary<SkeletonEditing, SkeletonTarget>();

        /// <param name="targets">The skeletons, each once.</param>
        /// <param name="undo">Where commands are recorded.</param>
        public SkeletonSession(IEnumerable<SkeletonTarget> targets, IUndoRecorder undo)
        {
            m_Targets = new List<SkeletonTarget>(targets);
            var all = new List<SkeletonEditing>();
            foreach (SkeletonTarget target in m_Targets)
            {
                var editing = new SkeletonEditing(JointSelection.Of(target.Skeleton), undo);
                if (target.HasSurface)
                    editing.Surface = new SnapSurface(target.Surface);
                all.Add(editing);
                m_TargetOf.Add(editing, target);
            }

            Group = new EditingGroup(all, undo);
            Pointer = new SkeletonPointer(Group, undo);
            Overlay = new WingOverlay();
            Place();
        }

        public EditingGroup Group { get; }

        public SkeletonPointer Pointer { get; }

        /// <summary>Overlay of the active wing.</summary>
        public WingOverlay Overlay { get; }

        /// <summary>Drag mode, unless a key chooses another.</summary>
        public DragMode Mode { get; set; } = DragMode.WingPlane;

        /// <summary>True where commands also change the wing on the other side.</summary>
        public bool IsSymmetric { get; set; }

        /// <summary>True where joints are numbered.</summary>
        public bool ShowsLabels { get; set; } = true;

        /// <summary>Reason why the last command was refused; null where it was done.</summary>
        public string LastRefusal { get; private set; }

        /// <summary>Wing of the active skeleton; null where there is none.</summary>
        public SkeletonTarget ActiveTarget => Group.Active == null ? null : m_TargetOf[Group.Active];

        /// <summary>Updates the skeletons by the present places of the wings. Call once an event.</summary>
        public void Place()
        {
            foreach (SkeletonEditing editing in Group.All)
            {
                SkeletonTarget target = m_TargetOf[editing];
                if (target.Skeleton == null)
                    continue;
                editing.LocalToWorld = target.LocalToWorld;
                editing.Lock = target.Lock;
                editing.Known = target.Known();
                editing.Twin = target.OtherSide?.Skeleton == null ? null : target.MakeTwin();

                editing.IsSymmetric = IsSymmetric;
            }

            if (ActiveTarget != null && ActiveTarget.Skeleton != null)
                Overlay.Refresh(ActiveTarget, Group.Active.Selection.Living(), Pointer.IsMoving);
        }

        /// <summary>Runs a command.</summary>
        public EditOutcome Do(EditCommand command) => Report(Group.Do(command));

        /// <summary>Records an outcome, for the panel.</summary>
        public EditOutcome Report(EditOutcome outcome)
        {
            LastRefusal = outcome.Message;
            return outcome;
        }

        /// <summary>
        /// Returns true where a skeleton was destroyed or a wing's object is gone, so that the session must be restarted.
        /// </summary>
        public bool IsStale() => m_Targets.Exists(target => target.Skeleton == null || (target.Place is object && target.Place == null));

        /// <summary>Selects some joints of a skeleton, and makes it the active one.</summary>
        public void Select(SkeletonEditing editing, IReadOnlyList<JointIndex> joints)
        {
            Group.Active = editing;
            Group.Select(editing, joints, adds: false);
        }

        /// <summary>Bounds of the selected joints, or of all where none is selected, for framing.</summary>
        public Bounds SelectedBounds()
        {
            bool any = Group.SelectedCount > 0;
            Bounds? bounds = null;
            float size = 0f;
            foreach (SkeletonEditing editing in Group.All)
            {
                Bounds? whole = null;
                foreach (JointIndex joint in JointPicking.All(editing.Skeleton))
                {
                    Vector3 place = editing.LocalToWorld.MultiplyPoint3x4(editing.Skeleton.GetJoint(joint.chain, joint.joint));
                    if (!SkeletonDraft.IsUsable(place))
                        continue;
                    whole = With(whole, place);
                    if (!any || editing.Selection.Contains(joint))
                        bounds = With(bounds, place);
                }

                size = Mathf.Max(size, whole?.size.magnitude ?? 0f);
            }

            // A single joint has no size: its surroundings are shown.
            Bounds framed = bounds ?? new Bounds(Vector3.zero, Vector3.one);
            framed.Expand(0.1f * size);
            return framed;
        }

        public void Dispose()
        {
            Pointer.Cancel();
            Overlay.Dispose();
        }

        private static Bounds With(Bounds? bounds, Vector3 place)
        {
            Bounds grown = bounds ?? new Bounds(place, Vector3.zero);
            grown.Encapsulate(place);
            return grown;
        }
    }
}
