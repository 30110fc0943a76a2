using System;
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Content of the panel: counts, problems, settings and commands of a session.</summary>
    internal static class SkeletonPanel
    {
        private const float k_Width = 260f;
        private const float k_SelectWidth = 52f;
        private const int k_MaxProblems = 6;

        private static class Content
        {
            public static readonly GUIContent Chains = new GUIContent("Chains", "3 to 16. Another number lays the same fan out again.");
            public static readonly GUIContent Joints = new GUIContent(
                "Joints", "Joints of each chain, 3 to 16. Another number spaces them evenly.");
            public static readonly GUIContent Symmetric = new GUIContent(
                "Symmetric (Shift+M)", "Do everything to the wing on the other side too.");
            public static readonly GUIContent Labels = new GUIContent("Labels", "Number chains and joints.");
            public static readonly GUIContent Beat = new GUIContent("Show beat (K)", "Show the wing in level flight, at the phase below.");
            public static readonly GUIContent Phase = new GUIContent("Phase", "Share of the beat; 0 is the top of the stroke.");
            public static readonly GUIContent Select = new GUIContent("Select", "Select the joints concerned, and show the place.");

            public static readonly GUIContent[] Modes =
            {
                new GUIContent("Plane", "Drag within the plane of the wing."),
                new GUIContent("Free", "Drag within the plane of the screen."),
                new GUIContent("Surface", "Drag over the mesh; with any other setting, hold Ctrl or Cmd."),
                new GUIContent("Chain", "Slide along the chains; with any other setting, hold Shift."),
            };

            public static readonly GUIContent Colours = new GUIContent("Colours", "What the colours over the wing show.");

            public static readonly GUIContent[] ColourModes =
            {
                new GUIContent("None"), new GUIContent("Weight of selected joints"), new GUIContent("Mass"), new GUIContent("Delay"),
                new GUIContent("Patches"),
            };
        }

        public static void Draw(SkeletonSession session)
        {
            SkeletonEditing editing = session.Group.Active;
            using (new EditorGUILayout.VerticalScope(GUILayout.Width(k_Width)))
            {
                if (editing == null)
                    EditorGUILayout.HelpBox("None of the selected insects has a wing with a skeleton.", MessageType.Info);
                else
                    Draw(session, editing);
                LayOut(session);
            }

            Keys(session);
            if (GUI.changed)
                SceneView.RepaintAll();
        }

        private static void Draw(SkeletonSession session, SkeletonEditing editing)
        {
            ChooseActive(session);
            Counts(session, editing);
            session.Mode = (DragMode)GUILayout.Toolbar((int)session.Mode, Content.Modes);
            using (new EditorGUI.DisabledScope(editing.Twin == null))
                session.IsSymmetric = EditorGUILayout.Toggle(Content.Symmetric, session.IsSymmetric);
            session.ShowsLabels = EditorGUILayout.Toggle(Content.Labels, session.ShowsLabels);
            Problems(session, editing);
            if (session.LastRefusal != null)
                EditorGUILayout.HelpBox(session.LastRefusal, MessageType.Warning);
            Pictures(session.Overlay);
            DrawCommands(session);
        }

        // A click in the panel takes the focus from the scene: the keys go on working, but where text is being typed.
        private static void Keys(SkeletonSession session)
        {
            Event now = Event.current;
            if (now.type == EventType.KeyDown && !EditorGUIUtility.editingTextField
                && SkeletonKeys.Press(session, now.keyCode, now.modifiers))
            {
                now.Use();
            }
        }

        private static void LayOut(SkeletonSession session)
        {
            EditOutcome? outcome = SkeletonMakerGui.Draw();
            if (!outcome.HasValue)
                return;
            session.Report(outcome.Value);

            // A dialog was open meanwhile: what is drawn of this event is out of date.
            GUIUtility.ExitGUI();
        }

        private static void ChooseActive(SkeletonSession session)
        {
            IReadOnlyList<SkeletonEditing> all = session.Group.All;
            if (all.Count == 1)
            {
                EditorGUILayout.LabelField(all[0].Skeleton.name, EditorStyles.boldLabel);
                return;
            }

            string[] names = new string[all.Count];
            int active = 0;
            for (int k = 0; k < names.Length; k++)
            {
                // Numbered, for menus drop names that come twice.
                names[k] = $"{k + 1}  {all[k].Skeleton.name}";
                active = all[k] == session.Group.Active ? k : active;
            }

            session.Group.Active = all[EditorGUILayout.Popup("Skeleton", active, names)];
        }

        private static void Counts(SkeletonSession session, SkeletonEditing editing)
        {
            // Where counts are not in order, sliders would put them into their range by themselves; Mend is for that.
            if (SkeletonDraft.Read(editing.Skeleton, out SkeletonDraft draft) != null || draft.FindFault() != null)
                return;
            int chains = draft.ChainCount, joints = draft.JointsPerChain;
            int wantedChains = EditorGUILayout.IntSlider(Content.Chains, chains, WingSkeleton.MinChains, WingSkeleton.MaxChains);
            int wantedJoints = EditorGUILayout.IntSlider(Content.Joints, joints, WingSkeleton.MinJoints, WingSkeleton.MaxJoints);
            if (wantedChains != chains || wantedJoints != joints)
            {
                session.Report(
                    editing.Do("Set Counts", (present, selected) => ResampleCommands.ToCounts(present, wantedChains, wantedJoints)));
            }
        }

        private static void Problems(SkeletonSession session, SkeletonEditing editing)
        {
            List<SkeletonProblem> problems = editing.Skeleton.Validate();
            for (int k = 0; k < Math.Min(problems.Count, k_MaxProblems); k++)
            {
                SkeletonProblem problem = problems[k];
                if (Problem(problem.Message, MessageType.Error))
                    Show(session, editing, SelectCommands.Of(editing.Skeleton, problem));
            }

            IReadOnlyList<RigProblem> weaknesses = session.Overlay.Problems;
            for (int k = 0; k < Math.Min(weaknesses.Count, k_MaxProblems - problems.Count); k++)
            {
                if (Problem(
                    weaknesses[k].Message, weaknesses[k].Kind == RigProblemKind.DoesNotFit ? MessageType.Error : MessageType.Warning))
                {
                    Show(session, editing, weaknesses[k].Joints);
                }
            }

            int hidden = problems.Count + weaknesses.Count - k_MaxProblems;
            if (hidden > 0)
                EditorGUILayout.LabelField($"and {hidden} more");
        }

        /// <summary>A problem with its button.</summary>
        /// <returns>Whether the button was pressed.</returns>
        public static bool Problem(string message, MessageType type)
        {
            using (new EditorGUILayout.HorizontalScope())
            {
                EditorGUILayout.HelpBox(message, type);
                return GUILayout.Button(Content.Select, GUILayout.Width(k_SelectWidth));
            }
        }

        /// <summary>Selects joints and shows them in the scene view.</summary>
        public static void Show(SkeletonSession session, SkeletonEditing editing, IReadOnlyList<JointIndex> joints)
        {
            session.Select(editing, joints);
            if (SceneView.lastActiveSceneView != null)
                SceneView.lastActiveSceneView.Frame(session.SelectedBounds(), false);
        }

        private static void Pictures(WingOverlay overlay)
        {
            overlay.ShowsBeat = EditorGUILayout.Toggle(Content.Beat, overlay.ShowsBeat);
            if (overlay.ShowsBeat)
                overlay.Phase = EditorGUILayout.Slider(Content.Phase, overlay.Phase, 0f, 1f);
            int mode = overlay.Colours == null ? 0 : 1 + (int)overlay.Colours.Value;
            mode = EditorGUILayout.Popup(Content.Colours, mode, Content.ColourModes);
            overlay.Colours = mode == 0 ? (RigColourMode?)null : (RigColourMode)(mode - 1);
            if (overlay.Colours != null && overlay.Rig != null)
                Legend(RigColouring.Legend(overlay.Rig, overlay.Colours.Value, overlay.Parameters));
            if ((overlay.ShowsBeat || overlay.Colours != null) && overlay.Refusal != null)
                EditorGUILayout.HelpBox(overlay.Refusal, MessageType.Info);
        }

        private static void Legend((string low, string high)? ends)
        {
            if (ends == null)
                return;
            Rect bar = GUILayoutUtility.GetRect(k_Width, 12f);
            for (int k = 0; k < (int)bar.width; k++)
                EditorGUI.DrawRect(new Rect(bar.x + k, bar.y, 1f, bar.height), RigColouring.Ramp(k / bar.width));
            EditorGUILayout.LabelField(ends.Value.low, ends.Value.high, EditorStyles.miniLabel);
        }

        private static void DrawCommands(SkeletonSession session)
        {
            foreach (SkeletonCommandGroup group in SkeletonCommands.Groups)
            {
                EditorGUILayout.LabelField(group.Name, EditorStyles.miniBoldLabel);
                for (int k = 0; k < group.Commands.Count; k += 2)
                {
                    using (new EditorGUILayout.HorizontalScope())
                    {
                        DrawCommand(session, group.Commands[k]);
                        if (k + 1 < group.Commands.Count)
                            DrawCommand(session, group.Commands[k + 1]);
                    }
                }
            }
        }

        private static void DrawCommand(SkeletonSession session, EditCommand command)
        {
            string tooltip = command.Key == KeyCode.None ? command.Tooltip : $"{command.Tooltip} ({command.Shortcut})";
            if (GUILayout.Button(new GUIContent(command.Name, tooltip), EditorStyles.miniButton, GUILayout.Width(0.5f * k_Width)))
                session.Do(command);
        }
    }
}
