using System.Collections.Generic;
using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Draws <see cref="InsectMotion"/>: the body only where it counts, thresholds only where jumps are heeded.</summary>
    [CustomPropertyDrawer(typeof(InsectMotion))]
    internal sealed class InsectMotionDrawer : RowsDrawer
    {
        /// <inheritdoc/>
        protected override void ListRows(SerializedProperty property, List<SerializedProperty> rows)
        {
            SerializedProperty source = property.FindPropertyRelative(nameof(InsectMotion.source));
            SerializedProperty response = property.FindPropertyRelative(nameof(InsectMotion.onTeleport));
            rows.Add(source);
            if (source.hasMultipleDifferentValues || source.intValue == (int)VelocitySource.Rigidbody)
                rows.Add(property.FindPropertyRelative(nameof(InsectMotion.body)));
            rows.Add(property.FindPropertyRelative(nameof(InsectMotion.metresPerUnit)));
            rows.Add(response);
            if (!response.hasMultipleDifferentValues && response.intValue == (int)TeleportResponse.Ignore)
                return;
            rows.Add(property.FindPropertyRelative(nameof(InsectMotion.teleportDistance)));
            rows.Add(property.FindPropertyRelative(nameof(InsectMotion.teleportAngle)));
        }
    }
}
