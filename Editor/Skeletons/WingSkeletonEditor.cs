using System;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of <see cref="WingSkeleton"/>: its state first, then editing in the scene view, its rig, its fields.</summary>
    [CustomEditor(typeof(WingSkeleton))]
    [CanEditMultipleObjects]
    internal sealed class WingSkeletonEditor : UnityEditor.Editor
    {
        private static class Content
        {
            public const string Usable = "This skeleton can be used.";

            public static readonly GUIContent Size = new GUIContent(
                "Size", "Chains from leading to trailing edge, and joints of each from root to tip.");
            public static readonly GUIContent Edit = new GUIContent(
                "Edit In Scene View", "Edit the joints at the origin of the scene. To edit them on an insect, select the insect and take "
                    + "the Wing Skeleton tool.");

            public static readonly GUIContent Mirror = new GUIContent(
                "Save Mirror Image…", "Save the skeleton of the other side's wing, mirrored across x = 0 of the mesh's space.");

            public static readonly GUIContent Hinge = new GUIContent(
                "Hinge", "Where the wing turns, mesh units; usually the root of the first chain.");
            public static readonly GUIContent SpanAxis = new GUIContent("Span Axis", "From hinge to tip, in mesh space. Any length.");
            public static readonly GUIContent UpAxis = new GUIContent("Up Axis", "The wing's upper side, in mesh space. Any length.");
            public static readonly GUIContent Chains = new GUIContent(
                "Chains", "Joints from root to tip, mesh units; the first chain lies on the leading edge. All chains have the same "
                    + "number of joints.");

            public static string More(int count) => count == 1 ? "One more problem." : $"{count} more problems.";
        }

        private readonly SkeletonSceneGui m_Gui = new SkeletonSceneGui();
        private SerializedProperty m_Hinge;
        private SerializedProperty m_SpanAxis;
        private SerializedProperty m_UpAxis;
        private SerializedProperty m_Chains;
        private SkeletonReport m_Report;
        private SkeletonRigSection m_Rig;
        private SkeletonSession m_Session;

        private bool IsEditing => m_Session != null && m_Session == SkeletonSessions.Current;

        private void OnEnable()
        {
            m_Hinge = serializedObject.FindProperty("m_Hinge");
            m_SpanAxis = serializedObject.FindProperty("m_SpanAxis");
            m_UpAxis = serializedObject.FindProperty("m_UpAxis");
            m_Chains = serializedObject.FindProperty("m_Chains");
            if (targets.Length == 1)
                m_Rig = new SkeletonRigSection((WingSkeleton)target);
            SceneView.duringSceneGui += OnScene;
        }

        private void OnDisable()
        {
            SceneView.duringSceneGui -= OnScene;
            SkeletonSessions.Close(m_Session);
            m_Session = null;
            m_Rig?.Dispose();
            m_Gui.Dispose();
        }

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            if (serializedObject.UpdateIfRequiredOrScript() || m_Report == null)
                UpdateReport();
            ShowState();
            if (m_Rig != null)
                ShowTools();
            EditorGUILayout.Space();
            EditorGUILayout.PropertyField(m_Hinge, Content.Hinge);
            EditorGUILayout.PropertyField(m_SpanAxis, Content.SpanAxis);
            EditorGUILayout.PropertyField(m_UpAxis, Content.UpAxis);
            EditorGUILayout.PropertyField(m_Chains, Content.Chains);
            if (serializedObject.ApplyModifiedProperties())
                UpdateReport();
        }

        private void UpdateReport() => m_Report = SkeletonReport.Of(Array.ConvertAll(targets, chosen => (WingSkeleton)chosen));

        private void ShowState()
        {
            EditorGUILayout.LabelField(Content.Size, new GUIContent(m_Report.Size));
            foreach (string problem in m_Report.Problems)
                EditorGUILayout.HelpBox(problem, MessageType.Error);
            if (m_Report.HiddenProblems > 0)
                EditorGUILayout.HelpBox(Content.More(m_Report.HiddenProblems), MessageType.Error);
            if (m_Report.Problems.Count == 0)
                EditorGUILayout.HelpBox(Content.Usable, MessageType.Info);
        }

        private void ShowTools()
        {
            // Another mesh was chosen.
            if (IsEditing && m_Session.ActiveTarget != m_Rig.Target)
                m_Session = SkeletonSessions.Open(new[] { m_Rig.Target });
            using (new EditorGUILayout.HorizontalScope())
            {
                bool edits = GUILayout.Toggle(IsEditing, Content.Edit, EditorStyles.miniButton);
                if (edits != IsEditing)
                    Edit(edits);
                if (GUILayout.Button(Content.Mirror, EditorStyles.miniButton))
                {
                    SaveMirrorImage();

                    // A dialog was open meanwhile: what is drawn of this event is out of date.
                    GUIUtility.ExitGUI();
                }
            }

            if (m_Rig.Draw(out RigProblem pressed))
            {
                Edit(true);
                SkeletonPanel.Show(m_Session, m_Session.Group.Active, pressed.Joints);
            }
        }

        private void Edit(bool on)
        {
            if (on && !IsEditing)
                m_Session = SkeletonSessions.Open(new[] { m_Rig.Target });
            else if (!on)
                SkeletonSessions.Close(m_Session);
        }

        private void SaveMirrorImage()
        {
            var skeleton = (WingSkeleton)target;
            WingSkeleton made = SkeletonMirror.Create(skeleton, SkeletonMirror.AcrossX, out string refusal);
            if (made != null)
            {
                string path = AssetPath.Ask(
                    "Save Mirror Image", AssetPath.FileName(made.name), "Choose where the other side's skeleton is saved.");
                bool given = !string.IsNullOrEmpty(path);
                refusal = given ? AssetPath.FindProblem(path) : null;
                if (given && refusal == null)
                    AssetWriter.Save(made, path, Content.Mirror.text);
                else
                    DestroyImmediate(made);
            }

            if (refusal != null)
                EditorUtility.DisplayDialog("Wing Skeleton", refusal, "OK");
        }

        private void OnScene(SceneView view)
        {
            if (!IsEditing || m_Session.IsStale())
                return;
            m_Gui.OnGUI(view, m_Session);
            Repaint();
        }
    }
}
