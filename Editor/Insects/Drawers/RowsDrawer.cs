using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Draws a struct below a foldout: only the fields that matter for the values of the others, each with its own tooltip.
    /// </summary>
    internal abstract class RowsDrawer : PropertyDrawer
    {
        private readonly List<SerializedProperty> m_Rows = new List<SerializedProperty>();

        /// <summary>Adds the fields to show now, from top to bottom.</summary>
        protected abstract void ListRows(SerializedProperty property, List<SerializedProperty> rows);

        /// <summary>Label of the foldout.</summary>
        protected virtual GUIContent Title(SerializedProperty property, GUIContent label) => label;

        /// <summary>Draws a field.</summary>
        protected virtual void DrawRow(Rect position, SerializedProperty row) => EditorGUI.PropertyField(position, row, true);

        /// <inheritdoc/>
        public sealed override float GetPropertyHeight(SerializedProperty property, GUIContent label)
        {
            float height = EditorGUIUtility.singleLineHeight;
            if (!property.isExpanded)
                return height;
            foreach (SerializedProperty row in RowsOf(property))
                height += EditorGUIUtility.standardVerticalSpacing + EditorGUI.GetPropertyHeight(row, true);
            return height;
        }

        /// <inheritdoc/>
        public sealed override void OnGUI(Rect position, SerializedProperty property, GUIContent label)
        {
            var lines = new Rows(position);
            Rect header = lines.Next();
            using (var scope = new EditorGUI.PropertyScope(header, Title(property, label), property))
                property.isExpanded = EditorGUI.Foldout(header, property.isExpanded, scope.content, true);
            if (!property.isExpanded)
                return;
            using (new EditorGUI.IndentLevelScope())
            {
                foreach (SerializedProperty row in RowsOf(property))
                    DrawRow(lines.Next(EditorGUI.GetPropertyHeight(row, true)), row);
            }
        }

        private List<SerializedProperty> RowsOf(SerializedProperty property)
        {
            m_Rows.Clear();
            ListRows(property, m_Rows);
            return m_Rows;
        }
    }
}
