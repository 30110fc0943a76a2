using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Drag of the selected joints, of one skeleton or of several at once, from press to release: one step of undo. Always starts from the
    /// original positions, so that going back with the pointer goes back with the joints.
    /// </summary>
    internal sealed class JointDrag
    {
        private const string k_UndoName = "Move Joints";

        private readonly IUndoRecorder m_Undo;
        private readonly SkeletonEditing m_Grabbed;
        private readonly JointIndex m_Joint;
        private readonly List<(SkeletonEditing editing, EditStart start, JointIndex[] joints)> m_Parts =
            new List<(SkeletonEditing, EditStart, JointIndex[])>();

        private readonly Vector3 m_Anchor;
        private readonly SkeletonDraft m_Start;

        /// <summary>Begins a drag of all selected joints; the grabbed one follows the pointer.</summary>
        public JointDrag(IReadOnlyList<SkeletonEditing> all, SkeletonEditing grabbed, JointIndex joint, IUndoRecorder undo)
        {
            m_Undo = undo;
            m_Grabbed = grabbed;
            m_Joint = joint;
            m_Anchor = grabbed.LocalToWorld.MultiplyPoint3x4(grabbed.Skeleton.GetJoint(joint.chain, joint.joint));
            foreach (SkeletonEditing editing in all)
            {
                JointIndex[] joints = editing.Selection.Living();
                if (joints.Length == 0 || editing.Start(out EditStart start) != null)
                    continue;
                m_Parts.Add((editing, start, joints));
                if (editing == grabbed)
                    m_Start = start.Own;
            }

            m_Undo.Begin(k_UndoName);
        }

        /// <summary>Moves the joints so that the grabbed one is under the ray.</summary>
        /// <returns>Why they stay where they were, where they do.</returns>
        public EditOutcome Update(Ray ray, DragMode mode)
        {
            if (m_Start == null)
                return EditOutcome.Refused("The chains are not complete: mend the skeleton first.");
            Matrix4x4 toMesh = m_Grabbed.LocalToWorld.inverse;
            if (mode == DragMode.Chain)
                return Slide(toMesh.MultiplyPoint3x4(ray.origin), toMesh.MultiplyVector(ray.direction));
            if (!TryTarget(ray, mode, toMesh, out Vector3 target))
                return EditOutcome.Refused("The pointer is off the plane of the wing.");
            return Move(target - m_Anchor, mode);
        }

        /// <summary>Ends the drag, which can be undone.</summary>
        public void End() => m_Undo.End();

        /// <summary>Ends the drag and restores all joints.</summary>
        public void Cancel() => m_Undo.Cancel();

        private bool TryTarget(Ray ray, DragMode mode, Matrix4x4 toMesh, out Vector3 target)
        {
            if (mode == DragMode.Free)
                return DragPlane.TryPoint(ray, m_Anchor, ray.direction, out target);
            Vector3 origin = toMesh.MultiplyPoint3x4(ray.origin), direction = toMesh.MultiplyVector(ray.direction);
            if (mode == DragMode.Surface && m_Grabbed.Surface != null && m_Grabbed.Surface.TryHit(origin, direction, out Vector3 hit))
            {
                target = m_Grabbed.LocalToWorld.MultiplyPoint3x4(hit);
                return true;
            }

            return DragPlane.TryPoint(ray, m_Anchor, WorldNormal(), out target);
        }

        // A plane's normal goes to the world by the inverse transpose: two vectors in the plane go by the matrix itself.
        private Vector3 WorldNormal()
        {
            if (!WingAxes.TryMake(m_Start.SpanAxis, m_Start.UpAxis, out float3x3 axes))
                axes = float3x3.identity;
            Vector3 span = m_Grabbed.LocalToWorld.MultiplyVector(axes.c0), forward = m_Grabbed.LocalToWorld.MultiplyVector(axes.c2);
            return Vector3.Cross(span, forward);
        }

        private EditOutcome Move(Vector3 worldDelta, DragMode mode)
        {
            EditOutcome outcome = EditOutcome.Success;
            foreach ((SkeletonEditing editing, EditStart start, JointIndex[] joints) in m_Parts)
            {
                Vector3 delta = editing.LocalToWorld.inverse.MultiplyVector(worldDelta);
                Proposal moved = mode == DragMode.Surface && editing.Surface != null
                    ? MoveCommands.OnSurface(start.Own, joints, delta, editing.Surface)
                    : MoveCommands.By(start.Own, joints, delta);
                outcome = FirstRefusal(outcome, editing.Commit(k_UndoName, start, moved));
            }

            return outcome;
        }

        private EditOutcome Slide(Vector3 origin, Vector3 direction)
        {
            var path = new JointPath(m_Start.Chain(m_Joint.chain));
            float distance = path.ClosestTo(origin, direction) - path.DistanceOf(m_Joint.joint);
            EditOutcome outcome = EditOutcome.Success;
            float scale = ScaleOf(m_Grabbed.LocalToWorld);
            foreach ((SkeletonEditing editing, EditStart start, JointIndex[] joints) in m_Parts)
            {
                float own = distance * (editing == m_Grabbed ? 1f : scale / ScaleOf(editing.LocalToWorld));
                outcome = FirstRefusal(outcome, editing.Commit(k_UndoName, start, SlideCommands.By(start.Own, joints, own)));
            }

            return outcome;
        }

        // World units that a mesh unit is long, on average over all directions.
        private static float ScaleOf(Matrix4x4 localToWorld) => Mathf.Pow(Mathf.Abs(localToWorld.determinant), 1f / 3f);

        private static EditOutcome FirstRefusal(EditOutcome first, EditOutcome next) => first.Done ? next : first;
    }
}
