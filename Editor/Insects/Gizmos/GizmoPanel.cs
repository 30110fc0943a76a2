using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>A toggle for each layer of gizmos.</summary>
    internal sealed class GizmoPanel
    {
        private static class Content
        {
            public static readonly (GizmoLayers layer, GUIContent label)[] Toggles =
            {
                (GizmoLayers.Chains, new GUIContent(
                    "Chains", "Joints and bones, coloured by when the wave reaches them: yellow first, blue last.")),
                (GizmoLayers.Axes, new GUIContent("Hinge And Axes", "Hinge, span (red) and up axis (green) of each wing.")),
                (GizmoLayers.Force, new GUIContent(
                    "Air Force", "The air's force on each wing, in play; as long as the wing where it equals the insect's weight.")),
                (GizmoLayers.Loads, new GUIContent(
                    "Patch Loads", "The air's force on each patch of the surface, in play. Keeps the loads in memory while it is on.")),
                (GizmoLayers.Velocity, new GUIContent(
                    "Velocity And Wind", "The body's velocity and the wind, in play; as long as the way in one beat.")),
                (GizmoLayers.Wake, new GUIContent(
                    "Wake", "Vortex rings that the wings leave in the air, in play, as if the insect flew on as it does now: orange and "
                    + "blue turn opposite ways, the denser the stronger. A wake takes a second or so to appear, and some of each "
                    + "frame's time.")),
                (GizmoLayers.Bounds, new GUIContent("Bounds", "Bounds of the wings' meshes; in play those of the deformed part.")),
            };
        }

        /// <summary>Draws the next lines of the inspector.</summary>
        public void Draw()
        {
            GizmoLayers layers = GizmoSettings.Layers, chosen = layers;
            foreach ((GizmoLayers layer, GUIContent label) in Content.Toggles)
            {
                bool on = EditorGUILayout.Toggle(label, (layers & layer) != 0);
                chosen = on ? chosen | layer : chosen & ~layer;
            }

            if (chosen == layers)
                return;
            GizmoSettings.Layers = chosen;
            SceneView.RepaintAll();
        }
    }
}
