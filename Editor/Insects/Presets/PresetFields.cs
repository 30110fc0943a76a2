using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Sliders of the insect's preset, below the field that names it, for tuning while the insect beats.</summary>
    internal sealed class PresetFields
    {
        private static class Content
        {
            public const string Shared =
                "Changes are made to the preset itself: all insects that use it follow, and they stay when play ends.";
            public const string Locked = "This preset cannot be changed where it lies. Save it as a preset of your own to tune it.";

            public static readonly GUIContent Title = new GUIContent(
                "Tune Preset", "All values of the preset. Wings that live take them over at their next step.");
        }

        private readonly Section m_Section = new Section(Content.Title, "Preset", false);
        private UnityEditor.Editor m_Editor;

        /// <summary>Draws the next lines of the inspector; none where there is no preset, or several different ones.</summary>
        public void Draw(SerializedProperty preset)
        {
            if (preset.hasMultipleDifferentValues || preset.objectReferenceValue == null || !m_Section.Draw())
                return;
            Object asset = preset.objectReferenceValue;
            bool locked = AssetLock.IsLocked(asset);
            UnityEditor.Editor.CreateCachedEditor(asset, null, ref m_Editor);
            EditorGUILayout.LabelField(locked ? Content.Locked : Content.Shared, EditorStyles.wordWrappedMiniLabel);
            using (new EditorGUI.IndentLevelScope())
            using (new EditorGUI.DisabledScope(locked))
                m_Editor.OnInspectorGUI();
        }

        /// <summary>Frees the sliders when the inspector is closed.</summary>
        public void Close()
        {
            if (m_Editor != null)
                Object.DestroyImmediate(m_Editor);
        }
    }
}
