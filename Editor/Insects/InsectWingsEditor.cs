using System;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of <see cref="InsectWings"/>: its state with fixes, its fields, its beat while it plays.</summary>
    [CustomEditor(typeof(InsectWings))]
    [CanEditMultipleObjects]
    internal sealed class InsectWingsEditor : UnityEditor.Editor
    {
        private static class Content
        {
            public static readonly GUIContent FindWings = new GUIContent(
                "Find Wings", "Looks for wings below this object by names and by symmetry. Wings already in the list keep their settings.");

            public static readonly GUIContent LayOut = new GUIContent(
                "Lay Out Skeletons…",
                "Lays out joint chains on all wings without a skeleton and saves them as assets, to be looked at and edited. "
                + "Without that it is done again whenever play begins.");

            public static readonly GUIContent Live = new GUIContent("Live", "What the wings do while the game plays.");
            public static readonly GUIContent Gizmos = new GUIContent(
                "Gizmos", "What is drawn over selected insects in the scene view; kept on this machine, not in the scene.");
            public static readonly GUIContent Events = new GUIContent("Events", "Calls at the start of each beat.");
            public const string OneOnly = "Select one insect alone to see its beat.";
        }

        private readonly Section m_LiveSection = new Section(Content.Live, "Live", true);
        private readonly Section m_GizmoSection = new Section(Content.Gizmos, "Gizmos", false);
        private readonly Section m_EventSection = new Section(Content.Events, "Events", false);
        private readonly StatusBox m_Status = new StatusBox();
        private readonly LivePanel m_Live = new LivePanel();
        private readonly GizmoPanel m_Gizmos = new GizmoPanel();
        private readonly PresetPanel m_Presets = new PresetPanel(new PresetSaving(AssetPath.Ask));
        private readonly PresetFields m_Tuning = new PresetFields();
        private readonly InsectFix m_Find = new FindWingsFix();
        private readonly InsectFix m_LayOut = new LayOutSkeletonFix(LayOutSkeletonFix.Fit, AssetPath.Ask);

        private SerializedProperty m_Preset, m_Wings, m_UpdateMode, m_StartPhase, m_Steering, m_Motion, m_Air, m_Quality, m_Preview,
            m_OnWingBeat;
        private InsectWings[] m_Insects;

        private void OnEnable()
        {
            m_Insects = Array.ConvertAll(targets, chosen => (InsectWings)chosen);
            m_Preset = serializedObject.FindProperty("m_Preset");
            m_Wings = serializedObject.FindProperty("m_Wings");
            m_UpdateMode = serializedObject.FindProperty("m_UpdateMode");
            m_StartPhase = serializedObject.FindProperty("m_StartPhase");
            m_Steering = serializedObject.FindProperty("m_Steering");
            m_Motion = serializedObject.FindProperty("m_Motion");
            m_Air = serializedObject.FindProperty("m_Air");
            m_Quality = serializedObject.FindProperty("m_Quality");
            m_Preview = serializedObject.FindProperty("m_Preview");
            m_OnWingBeat = serializedObject.FindProperty("m_OnWingBeat");
            EditorApplication.update += RepaintWhileLive;
        }

        private void OnDisable()
        {
            EditorApplication.update -= RepaintWhileLive;
            m_Tuning.Close();
        }

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            bool changed = serializedObject.UpdateIfRequiredOrScript();
            if (Event.current.type == EventType.Layout)
                m_Status.Refresh(m_Insects, changed);
            if (m_Status.Draw())
                Refresh();
            EditorGUILayout.PropertyField(m_Preset);
            serializedObject.ApplyModifiedProperties();
            m_Tuning.Draw(m_Preset);
            if (m_Presets.Draw(m_Insects, out FixOutcome saved))
                Refresh(saved);
            DrawWings();
            EditorGUILayout.PropertyField(m_UpdateMode);
            EditorGUILayout.PropertyField(m_StartPhase);
            EditorGUILayout.PropertyField(m_Steering);
            EditorGUILayout.PropertyField(m_Motion);
            EditorGUILayout.PropertyField(m_Air);
            EditorGUILayout.PropertyField(m_Quality);
            EditorGUILayout.PropertyField(m_Preview);
            if (m_EventSection.Draw())
                EditorGUILayout.PropertyField(m_OnWingBeat);
            if (m_GizmoSection.Draw())
                m_Gizmos.Draw();
            if (m_LiveSection.Draw())
                DrawLive();
            serializedObject.ApplyModifiedProperties();
        }

        private void DrawWings()
        {
            EditorGUILayout.PropertyField(m_Wings);
            InsectFix pressed = null;
            using (new EditorGUILayout.HorizontalScope())
            {
                if (GUILayout.Button(Content.FindWings, EditorStyles.miniButtonLeft))
                    pressed = m_Find;
                if (GUILayout.Button(Content.LayOut, EditorStyles.miniButtonRight))
                    pressed = m_LayOut;
            }

            if (pressed == null)
                return;
            serializedObject.ApplyModifiedProperties();
            FixOutcome last = default;
            Edits.InOneStep(pressed.Label, () =>
            {
                foreach (InsectWings insect in m_Insects)
                    last = pressed.Apply(insect, InsectProblem.None);
            });
            Refresh(last);
        }

        private void DrawLive()
        {
            if (m_Insects.Length == 1)
                m_Live.Draw(m_Insects[0]);
            else
                EditorGUILayout.LabelField(Content.OneOnly, EditorStyles.miniLabel);
        }

        private void Refresh(FixOutcome outcome)
        {
            m_Status.Show(outcome);
            Refresh();
        }

        // The objects were changed beside the serialised ones: what is drawn of this event is out of date.
        private void Refresh()
        {
            serializedObject.Update();
            m_Status.Refresh(m_Insects, true);
            GUIUtility.ExitGUI();
        }

        private void RepaintWhileLive()
        {
            if (m_Insects.Length == 1 && m_LiveSection.IsOpen && m_Live.Refresh(m_Insects[0]))
                Repaint();
        }
    }
}
