using Alate.Crowds;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Draws the boxes in which spawners let insects fly.</summary>
    internal static class CrowdGizmos
    {
        [DrawGizmo(GizmoType.InSelectionHierarchy)]
        private static void Draw(CrowdSpawner spawner, GizmoType type)
        {
            Matrix4x4 before = Gizmos.matrix;
            Gizmos.color = GizmoColours.Bounds;
            Gizmos.matrix = Matrix4x4.TRS(spawner.transform.position, spawner.transform.rotation, spawner.Area);
            Gizmos.DrawWireCube(Vector3.zero, Vector3.one);
            Gizmos.matrix = before;
        }
    }
}
