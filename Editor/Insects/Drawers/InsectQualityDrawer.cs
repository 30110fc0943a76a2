using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws <see cref="InsectQuality"/>: one slider for each level of detail instead of a nameless vector.</summary>
    [CustomPropertyDrawer(typeof(InsectQuality))]
    internal sealed class InsectQualityDrawer : RowsDrawer
    {
        private static class Content
        {
            public static readonly Dictionary<string, GUIContent> Levels = new Dictionary<string, GUIContent>
            {
                ["x"] = Level("Fewer Substeps Below", "half the substeps"),
                ["y"] = Level("Coarse Patches Below", "fewer substeps and coarse patches"),
                ["z"] = Level("Waves Only Below", "the driven waves alone"),
                ["w"] = Level("Rest Below", "wings that come to rest"),
            };

            private static GUIContent Level(string name, string what) => new GUIContent(
                name, $"Share of the screen's height, 0 to 1, below which the insect is computed with {what}. 0 never does. Multiplied by the quality settings' LOD bias.");
        }

        /// <inheritdoc/>
        protected override void ListRows(SerializedProperty property, List<SerializedProperty> rows)
        {
            SerializedProperty levels = property.FindPropertyRelative(nameof(InsectQuality.levelOfDetail));
            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.substepsPerBeat)));
            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.patches)));
            rows.Add(levels);
            if (levels.hasMultipleDifferentValues || levels.boolValue)
            {
                SerializedProperty heights = property.FindPropertyRelative(nameof(InsectQuality.screenHeights));
                foreach (string component in Content.Levels.Keys)
                    rows.Add(heights.FindPropertyRelative(component));
            }

            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.culling)));
        }

        /// <inheritdoc/>
        protected override void DrawRow(Rect position, SerializedProperty row)
        {
            if (Content.Levels.TryGetValue(row.name, out GUIContent label))
                EditorGUI.Slider(position, row, 0f, 1f, label);
            else
                base.DrawRow(position, row);
        }
    }
}
