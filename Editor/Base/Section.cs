using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Foldout of an inspector that keeps its state until the editor is closed.</summary>
    internal sealed class Section
    {
        private readonly GUIContent m_Title;
        private readonly string m_Key;
        private readonly bool m_OpenAtFirst;

        /// <param name="title">With its tooltip.</param>
        /// <param name="key">Names the section among those of the inspector.</param>
        /// <param name="openAtFirst">Before the user has touched it.</param>
        public Section(GUIContent title, string key, bool openAtFirst)
        {
            m_Title = title;
            m_Key = "Alate.InsectWings.Section." + key;
            m_OpenAtFirst = openAtFirst;
        }

        /// <summary>True where the content is to be drawn.</summary>
        public bool IsOpen => SessionState.GetBool(m_Key, m_OpenAtFirst);

        /// <summary>Draws the title; returns true where the content is to be drawn.</summary>
        public bool Draw()
        {
            bool open = EditorGUILayout.Foldout(IsOpen, m_Title, true, EditorStyles.foldoutHeader);
            if (open != IsOpen)
                SessionState.SetBool(m_Key, open);
            return open;
        }
    }
}
