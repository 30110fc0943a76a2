using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Handles pressing, dragging and releasing the mouse: clicks select, drags from a joint move the selected joints, drags from nothing
    /// select by a box. Independent of windows, whose owner passes the events on.
    /// </summary>
    internal sealed class SkeletonPointer
    {
        /// <summary>Largest distance of a click from the joint that it takes, pixels.</summary>
        public const float PickRadius = 12f;

        /// <summary>Distance that the pointer moves before a click becomes a drag, pixels.</summary>
        public const float DragThreshold = 4f;

        private readonly EditingGroup m_Group;
        private readonly IUndoRecorder m_Undo;
        private ScreenProjection m_Project;
        private SkeletonEditing m_Grabbed;
        private JointIndex m_Joint;
        private Vector2 m_Pressed;
        private bool m_Down;
        private bool m_Dragging;
        private bool m_Adds;
        private bool m_ReleaseSelects;
        private JointDrag m_Drag;

        public SkeletonPointer(EditingGroup group, IUndoRecorder undo)
        {
            m_Group = group;
            m_Undo = undo;
        }

        /// <summary>True while the mouse is held down on the skeletons.</summary>
        public bool IsDown => m_Down;

        /// <summary>True while joints are being moved.</summary>
        public bool IsMoving => m_Drag != null;

        /// <summary>Selection box, pixels; null where none is drawn.</summary>
        public Rect? Box { get; private set; }

        /// <summary>Presses the mouse.</summary>
        /// <param name="project">The view, as long as the mouse is down.</param>
        /// <param name="pixel">Where.</param>
        /// <param name="adds">Adds to the selection, and takes from it what is selected.</param>
        /// <param name="clicks">2 for a double click, which selects the chain.</param>
        public void Press(ScreenProjection project, Vector2 pixel, bool adds, int clicks = 1)
        {
            Cancel();
            m_Project = project;
            m_Pressed = pixel;
            m_Adds = adds;
            m_Down = true;
            if (!m_Group.TryNearest(project, pixel, PickRadius, out m_Grabbed, out m_Joint))
                return;
            m_Group.Active = m_Grabbed;
            bool selected = m_Grabbed.Selection.Contains(m_Joint);
            m_ReleaseSelects = selected && !adds && clicks == 1;
            if (clicks == 2)
                m_Group.Select(m_Grabbed, SelectCommands.Chains(m_Grabbed.Skeleton, new[] { m_Joint }), adds);
            else if (selected && adds)
                Unselect();
            else if (!selected)
                m_Group.Select(m_Grabbed, new[] { m_Joint }, adds);
        }

        /// <summary>Moves the pressed mouse.</summary>
        /// <param name="pixel">Where to.</param>
        /// <param name="ray">From the eye through that pixel, world.</param>
        /// <param name="mode">Where dragged joints go.</param>
        public EditOutcome Move(Vector2 pixel, Ray ray, DragMode mode)
        {
            if (!m_Down)
                return EditOutcome.Success;
            m_Dragging |= Vector2.Distance(pixel, m_Pressed) >= DragThreshold;
            if (!m_Dragging)
                return EditOutcome.Success;
            if (m_Grabbed == null)
            {
                Box = Rect.MinMaxRect(
                    Mathf.Min(pixel.x, m_Pressed.x), Mathf.Min(pixel.y, m_Pressed.y),
                    Mathf.Max(pixel.x, m_Pressed.x), Mathf.Max(pixel.y, m_Pressed.y));
                return EditOutcome.Success;
            }

            m_Drag ??= new JointDrag(m_Group.Acting(), m_Grabbed, m_Joint, m_Undo);
            return m_Drag.Update(ray, mode);
        }

        /// <summary>Releases the mouse.</summary>
        public void Release()
        {
            if (!m_Down)
                return;
            if (Box.HasValue)
                m_Group.SelectInside(m_Project, Box.Value, m_Adds);
            else if (m_Grabbed == null && !m_Adds)
                m_Group.Select(null, Array.Empty<JointIndex>(), false);
            else if (m_ReleaseSelects && !m_Dragging)
                m_Group.Select(m_Grabbed, new[] { m_Joint }, false);
            m_Drag?.End();
            Clear();
        }

        /// <summary>Cancels the mouse's action; moved joints go back.</summary>
        public void Cancel()
        {
            m_Drag?.Cancel();
            Clear();
        }

        /// <summary>Forgets the mouse's action and leaves everything as it is, because undo has changed it under the pointer.</summary>
        public void LetGo()
        {
            m_Drag?.End();
            Clear();
        }

        // The joint that was just taken out is no longer there to be dragged.
        private void Unselect()
        {
            var left = new List<JointIndex>(m_Grabbed.Selection.Living());
            left.Remove(m_Joint);
            m_Grabbed.Select(left);
            m_Grabbed = null;
        }

        private void Clear()
        {
            m_Drag = null;
            m_Grabbed = null;
            m_Down = m_Dragging = m_ReleaseSelects = false;
            Box = null;
        }
    }
}
