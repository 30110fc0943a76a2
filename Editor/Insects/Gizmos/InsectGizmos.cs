using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Draws the gizmos of selected insects.</summary>
    internal static class InsectGizmos
    {
        private static readonly ScenePen s_Pen = new ScenePen();

        [DrawGizmo(GizmoType.InSelectionHierarchy)]
        private static void Draw(InsectWings insect, GizmoType type)
        {
            GizmoLayers layers = GizmoSettings.Layers;
            if (layers != GizmoLayers.None && insect.isActiveAndEnabled)
                InsectDrawing.Draw(insect, layers, s_Pen);
        }
    }
}
