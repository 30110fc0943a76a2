using System;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of <see cref="WingSkeleton"/>: its state first, then its fields.</summary>
    [CustomEditor(typeof(WingSkeleton))]
    [CanEditMultipleObjects]
    internal sealed class WingSkeletonEditor : UnityEditor.Editor
    {
        private static class Content
        {
            public const string Usable = "This skeleton can be used.";

            public static readonly GUIContent Size = new GUIContent("Size", "Chains from leading to trailing edge, and joints of each from root to tip.");
            public static readonly GUIContent Hinge = new GUIContent("Hinge", "Where the wing turns, mesh units; usually the root of the first chain.");
            public static readonly GUIContent SpanAxis = new GUIContent("Span Axis", "From hinge to tip, in mesh space. Any length.");
            public static readonly GUIContent UpAxis = new GUIContent("Up Axis", "The wing's upper side, in mesh space. Any length.");
            public static readonly GUIContent Chains = new GUIContent(
                "Chains", "Joints from root to tip, mesh units; the first chain lies on the leading edge. All chains have the same number of joints.");

            public static string More(int count) => count == 1 ? "One more problem." : $"{count} more problems.";
        }

        private SerializedProperty m_Hinge;
        private SerializedProperty m_SpanAxis;
        private SerializedProperty m_UpAxis;
        private SerializedProperty m_Chains;
        private SkeletonReport m_Report;

        private void OnEnable()
        {
            m_Hinge = serializedObject.FindProperty("m_Hinge");
            m_SpanAxis = serializedObject.FindProperty("m_SpanAxis");
            m_UpAxis = serializedObject.FindProperty("m_UpAxis");
            m_Chains = serializedObject.FindProperty("m_Chains");
        }

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            if (serializedObject.UpdateIfRequiredOrScript() || m_Report == null)
                Look();
            ShowState();
            EditorGUILayout.PropertyField(m_Hinge, Content.Hinge);
            EditorGUILayout.PropertyField(m_SpanAxis, Content.SpanAxis);
            EditorGUILayout.PropertyField(m_UpAxis, Content.UpAxis);
            EditorGUILayout.PropertyField(m_Chains, Content.Chains);
            if (serializedObject.ApplyModifiedProperties())
                Look();
        }

        private void Look() => m_Report = SkeletonReport.Of(Array.ConvertAll(targets, chosen => (WingSkeleton)chosen));

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
    }
}
