using UnityEditor;
using UnityEditor.Overlays;

namespace Alate.Editor
{
    /// <summary>Panel in the scene view while a skeleton is edited.</summary>
    [Overlay(typeof(SceneView), "alate-wing-skeleton", "Wing Skeleton", true)]
    internal sealed class SkeletonOverlay : IMGUIOverlay, ITransientOverlay
    {
        /// <inheritdoc/>
        public bool visible => SkeletonSessions.Current != null;

        /// <inheritdoc/>
        public override void OnGUI()
        {
            if (SkeletonSessions.Current != null && !SkeletonSessions.Current.IsStale())
                SkeletonPanel.Draw(SkeletonSessions.Current);
        }
    }
}
