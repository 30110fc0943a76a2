using Alate.Crowds;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of Insect Crowd: what keeps it from being drawn, what is drawn while playing, and the fields.</summary>
    [CustomEditor(typeof(InsectCrowd))]
    [CanEditMultipleObjects]
    internal sealed class InsectCrowdEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override bool RequiresConstantRepaint() => Application.isPlaying && targets.Length == 1;

        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            var crowd = (InsectCrowd)target;
            if (targets.Length == 1 && crowd.Problem != null)
                EditorGUILayout.HelpBox(crowd.Problem, MessageType.Warning);
            else if (targets.Length == 1 && Application.isPlaying)
                EditorGUILayout.HelpBox(Describe(crowd), MessageType.Info);
            DrawDefaultInspector();
        }

        private static string Describe(InsectCrowd crowd) =>
            $"{crowd.DrawnCount} of {crowd.Count} drawn, over all cameras, {crowd.LiveNow} live, "
            + $"{crowd.DrawCalls} draw calls, {crowd.Triangles / 1000} thousand triangles";
    }
}
