using System;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Passes the scene view's events to a session and draws the session.</summary>
    internal sealed class SkeletonSceneGui : IDisposable
    {
        private static readonly int s_Hint = "Alate.WingSkeleton".GetHashCode();

        private readonly OverlayMaterial m_Material = new OverlayMaterial();
        private SceneView m_Pressed;
        private bool m_MenuShown;

        /// <summary>Handles one event.</summary>
        public void OnGUI(SceneView view, SkeletonSession session)
        {
            session.Place();
            Event now = Event.current;
            int id = GUIUtility.GetControlID(s_Hint, FocusType.Passive);
            switch (now.GetTypeForControl(id))
            {
                case EventType.Layout:
                    HandleUtility.AddDefaultControl(id);
                    break;
                case EventType.MouseDown:
                    Press(view, session, now, id);
                    break;
                case EventType.ContextClick:
                    ContextClick(session, now);
                    break;
                case EventType.MouseDrag when GUIUtility.hotControl == id:
                    session.Report(session.Pointer.Move(now.mousePosition, RayAt(now), ModeOf(session, now)));
                    now.Use();
                    break;
                case EventType.MouseUp when GUIUtility.hotControl == id && now.button == 0:
                    session.Pointer.Release();
                    GUIUtility.hotControl = 0;
                    now.Use();
                    break;
                case EventType.MouseMove:
                    view.Repaint();
                    break;
                case EventType.KeyDown:
                    if (SkeletonKeys.Press(session, now.keyCode, now.modifiers))
                        Used(now, id);
                    break;
                case EventType.ValidateCommand:
                case EventType.ExecuteCommand:
                    Command(view, session, now);
                    break;
                case EventType.Repaint:
                    using (new Handles.DrawingScope(Color.white, Matrix4x4.identity))
                        Draw(view, session, now);
                    break;
            }
        }

        public void Dispose() => m_Material.Dispose();

        private void Press(SceneView view, SkeletonSession session, Event now, int id)
        {
            bool navigates = now.alt || Tools.viewToolActive;
            m_MenuShown = now.button == 1 && !navigates && TryShowMenu(session, now);
            if (now.button != 0 || navigates || HandleUtility.nearestControl != id)
                return;
            session.Pointer.Press(Project, now.mousePosition, now.shift || EditorGUI.actionKey, now.clickCount);
            GUIUtility.hotControl = id;
            m_Pressed = view;
            now.Use();
        }

        // In Unity 2022.3 the scene view's camera takes the press of the right button before any tool; of the click, this event still
        // tells.
        private void ContextClick(SkeletonSession session, Event now)
        {
            if (m_MenuShown)
                now.Use();
            else if (!now.alt)
                TryShowMenu(session, now);
            m_MenuShown = false;
        }

        private static void Command(SceneView view, SkeletonSession session, Event now)
        {
            if (!SkeletonKeys.Knows(now.commandName))
                return;
            if (now.type == EventType.ExecuteCommand)
            {
                if (now.commandName == SkeletonKeys.FrameSelected)
                    view.Frame(session.SelectedBounds(), false);
                else
                    SkeletonKeys.Execute(session, now.commandName);
            }

            now.Use();
        }

        private static void Used(Event now, int id)
        {
            if (now.keyCode == KeyCode.Escape && GUIUtility.hotControl == id)
                GUIUtility.hotControl = 0;
            now.Use();
        }

        private void Draw(SceneView view, SkeletonSession session, Event now)
        {
            SkeletonTarget target = session.ActiveTarget;
            if (target != null)
            {
                m_Material.Draw(session.Overlay.ColourMesh, target.LocalToWorld, Color.white);
                m_Material.Draw(session.Overlay.BeatMesh, target.LocalToWorld, SkeletonColours.beat);
                m_Material.Draw(session.Overlay.BeatMesh, target.LocalToWorld, SkeletonColours.beatEdges, edges: true);
                foreach (RigProblem problem in session.Overlay.Problems)
                    SkeletonDrawing.Ring(target.LocalToWorld.MultiplyPoint3x4(problem.Position), SkeletonColours.problem);
            }

            bool over = session.Group.TryNearest(
                Project, now.mousePosition, SkeletonPointer.PickRadius, out SkeletonEditing under, out JointIndex hovered);
            foreach (SkeletonEditing editing in session.Group.All)
            {
                SkeletonDrawing.Draw(
                    editing, editing == session.Group.Active, session.ShowsLabels, over && editing == under ? hovered : (JointIndex?)null);
            }

            if (session.Pointer.Box.HasValue && view == m_Pressed)
                DrawBox(session.Pointer.Box.Value);
        }

        private static void DrawBox(Rect box)
        {
            Handles.BeginGUI();
            Handles.DrawSolidRectangleWithOutline(box, SkeletonColours.box, SkeletonColours.boxEdge);
            Handles.EndGUI();
        }

        // A right click means the joint under it, and what is selected if that is among it.
        private static bool TryShowMenu(SkeletonSession session, Event now)
        {
            if (session.Pointer.IsDown || !session.Group.TryNearest(
                    Project, now.mousePosition, SkeletonPointer.PickRadius, out SkeletonEditing editing, out JointIndex joint))
            {
                return false;
            }

            if (!editing.Selection.Contains(joint))
                session.Select(editing, new[] { joint });
            SkeletonMenu.Show(session);
            now.Use();
            return true;
        }

        // Shift slides along the chain, Ctrl or Cmd snaps to the mesh, whatever the panel says.
        private static DragMode ModeOf(SkeletonSession session, Event now) =>
            now.shift ? DragMode.Chain : EditorGUI.actionKey ? DragMode.Surface : session.Mode;

        private static Ray RayAt(Event now) => HandleUtility.GUIPointToWorldRay(now.mousePosition);

        private static Vector3 Project(Vector3 world) => HandleUtility.WorldToGUIPointWithDepth(world);
    }
}
