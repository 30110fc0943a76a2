using System.Collections.Generic;
using UnityEditor;
using UnityEditor.EditorTools;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Edits the skeletons of the selected insects where their wings are.</summary>
    [EditorTool("Wing Skeleton", typeof(InsectWings))]
    internal sealed class WingSkeletonTool : EditorTool
    {
        private readonly SkeletonSceneGui m_Gui = new SkeletonSceneGui();
        private SkeletonSession m_Session;
        private GUIContent m_Icon;
        private int m_Stamp;

        /// <inheritdoc/>
        public override GUIContent toolbarIcon =>
            m_Icon ??= new GUIContent(
                EditorGUIUtility.IconContent("AvatarPivot").image, "Edit the wing skeletons of the selected insects.");

        /// <inheritdoc/>
        public override void OnActivated() => Begin();

        /// <inheritdoc/>
        public override void OnWillBeDeactivated() => End();

        /// <inheritdoc/>
        public override void OnToolGUI(EditorWindow window)
        {
            if (!(window is SceneView view))
                return;
            if (m_Session == null || m_Session != SkeletonSessions.Current || m_Session.IsStale()
                || m_Stamp != InsectTargets.StampOf(Insects()))
            {
                Begin();
            }
            m_Gui.OnGUI(view, m_Session);
        }

        private void OnDisable()
        {
            End();
            m_Gui.Dispose();
        }

        private void Begin()
        {
            List<InsectWings> insects = Insects();
            m_Stamp = InsectTargets.StampOf(insects);
            m_Session = SkeletonSessions.Open(InsectTargets.Find(insects));
        }

        private List<InsectWings> Insects()
        {
            var insects = new List<InsectWings>();
            foreach (Object chosen in targets)
            {
                if (chosen is InsectWings insect)
                    insects.Add(insect);
            }

            return insects;
        }

        private void End()
        {
            SkeletonSessions.Close(m_Session);
            m_Session = null;
        }
    }
}
