using Alate.Crowds;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Inspector of Crowd Spawner: what keeps it from placing insects, what is drawn while playing, and the fields.</summary>
    [CustomEditor(typeof(CrowdSpawner))]
    [CanEditMultipleObjects]
    internal sealed class CrowdSpawnerEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            var spawner = (CrowdSpawner)target;
            if (spawner.Problem != null)
                EditorGUILayout.HelpBox(spawner.Problem, MessageType.Warning);
            else if (Application.isPlaying)
                EditorGUILayout.HelpBox(Describe(spawner.GetComponent<InsectCrowd>()), MessageType.Info);
            DrawDefaultInspector();
        }

        private static string Describe(InsectCrowd crowd) =>
            $"{crowd.DrawnCount} of {crowd.Count} in sight, {crowd.LiveNow} live, "
            + $"{crowd.DrawCalls} draw calls, {crowd.Triangles / 1000} thousand triangles";
    }
}
