using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Gizmos that the user has chosen, on this machine.</summary>
    internal static class GizmoSettings
    {
        private const string k_Key = "Alate.InsectWings.Gizmos";
        private const GizmoLayers k_Default = GizmoLayers.Chains | GizmoLayers.Axes | GizmoLayers.Force;

        /// <summary>Chosen layers.</summary>
        public static GizmoLayers Layers
        {
            get => (GizmoLayers)EditorPrefs.GetInt(k_Key, (int)k_Default);
            set => EditorPrefs.SetInt(k_Key, (int)value);
        }
    }
}
