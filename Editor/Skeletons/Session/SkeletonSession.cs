using System;
using System.Collections.Generic;
using Alate.Fitting;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// All that lasts while skeletons are edited: the selections, what the mouse is doing, the settings of the panel, and what is shown over the
    /// wings. Knows no window. Dispose it.
    /// </summary>
    internal sealed class SkeletonSession : IDisposable
    {
        private readonly List<SkeletonTarget> m_Targets;
        private readonly Dictionary<SkeletonEditing, SkeletonTarget> m_TargetOf = new Dictionary<SkeletonEditing, SkeletonTarget>();

        /// <param name="targets">The skeletons, each once.</param>
        /// <param name="undo">Where acts are recorded.</param>
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

        /// <summary>What is shown over the active wing.</summary>
        public WingOverlay Overlay { get; }

        /// <summary>Where dragged joints go, unless a key says otherwise.</summary>
        public DragMode Mode { get; set; } = DragMode.WingPlane;

        /// <summary>Whether acts are done to the wing on the other side too.</summary>
        public bool IsSymmetric { get; set; }

        /// <summary>Whether joints are numbered.</summary>
        public bool ShowsLabels { get; set; } = true;

        /// <summary>Why the last act was refused; null where it was done.</summary>
        public string LastRefusal { get; private set; }

        /// <summary>The active skeleton's wing; null where there is none.</summary>
        public SkeletonTarget ActiveTarget => Group.Active == null ? null : m_TargetOf[Group.Active];

        /// <summary>Brings everything up to date with where the wings are now. Call once an event.</summary>
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

        /// <summary>Does an act.</summary>
        public EditOutcome Do(EditCommand act) => Report(Group.Do(act));

        /// <summary>Notes an outcome, for the panel.</summary>
        public EditOutcome Report(EditOutcome outcome)
        {
            LastRefusal = outcome.Message;
            return outcome;
        }

        /// <summary>Whether a skeleton was destroyed or a wing's object is gone, so that the session has to be begun again.</summary>
        public bool IsStale() => m_Targets.Exists(target => target.Skeleton == null || (target.Place is object && target.Place == null));

        /// <summary>Selects some joints of a skeleton, and makes it the active one.</summary>
        public void Select(SkeletonEditing editing, IReadOnlyList<JointIndex> joints)
        {
            Group.Active = editing;
            Group.Select(editing, joints, adds: false);
        }

        /// <summary>What to frame: the selected joints, or all where none is.</summary>
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
