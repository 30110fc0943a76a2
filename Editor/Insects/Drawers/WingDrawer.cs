using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws a <see cref="Wing"/> of the list: with its name, and the one field that selects the part of the mesh.</summary>
    [CustomPropertyDrawer(typeof(Wing))]
    internal sealed class WingDrawer : RowsDrawer
    {
        /// <inheritdoc/>
        protected override GUIContent Title(SerializedProperty property, GUIContent label)
        {
            SerializedProperty renderer = property.FindPropertyRelative(WingFields.Renderer);
            SerializedProperty side = property.FindPropertyRelative(WingFields.Side);
            SerializedProperty pair = property.FindPropertyRelative(WingFields.Pair);
            if (renderer.hasMultipleDifferentValues || side.hasMultipleDifferentValues || pair.hasMultipleDifferentValues)
                return label;
            string what = renderer.objectReferenceValue == null ? "no renderer" : renderer.objectReferenceValue.name;
            return new GUIContent($"{(WingPair)pair.intValue} {(WingSide)side.intValue} · {what}", label.tooltip);
        }

        /// <inheritdoc/>
        protected override void ListRows(SerializedProperty property, List<SerializedProperty> rows)
        {
            SerializedProperty part = property.FindPropertyRelative(WingFields.Part);
            rows.Add(property.FindPropertyRelative(WingFields.Renderer));
            rows.Add(part);
            if (!part.hasMultipleDifferentValues && part.intValue == (int)WingPart.Submesh)
                rows.Add(property.FindPropertyRelative(WingFields.Submesh));
            if (!part.hasMultipleDifferentValues && part.intValue == (int)WingPart.ConnectedPart)
                rows.Add(property.FindPropertyRelative(WingFields.Point));
            foreach (string field in WingFields.Rest)
                rows.Add(property.FindPropertyRelative(field));
        }
    }
}
