using Alate.Crowds;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Inspector of Crowd Spawner: what keeps it from placing insects, and the fields.</summary>
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
            DrawDefaultInspector();
        }
    }
}
