using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Draws <see cref="InsectQuality"/>: the thresholds of the levels of detail only where there are levels.</summary>
    [CustomPropertyDrawer(typeof(InsectQuality))]
    internal sealed class InsectQualityDrawer : RowsDrawer
    {
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
                rows.Add(heights.FindPropertyRelative(nameof(ScreenHeights.fewerSubstepsBelow)));
                rows.Add(heights.FindPropertyRelative(nameof(ScreenHeights.coarsePatchesBelow)));
                rows.Add(heights.FindPropertyRelative(nameof(ScreenHeights.wavesOnlyBelow)));
                rows.Add(heights.FindPropertyRelative(nameof(ScreenHeights.restBelow)));
            }

            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.culling)));
            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.keepForces)));
            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.motionVectors)));
            rows.Add(property.FindPropertyRelative(nameof(InsectQuality.skinning)));
        }
    }
}
