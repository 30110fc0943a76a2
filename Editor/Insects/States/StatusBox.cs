using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>The one help box of the inspector, with a button for each fix, and what the last fix answered.</summary>
    internal sealed class StatusBox
    {
        private InsectStatus m_Status;
        private string m_Answer = "";

        /// <summary>Looks at the selected insects; a status that has changed takes back the last answer.</summary>
        public void Look(IReadOnlyList<InsectWings> insects)
        {
            InsectStatus now = InsectStatus.Of(insects);
            if (now.Message != m_Status.Message && now.IsShown)
                m_Answer = "";
            m_Status = now;
        }

        /// <summary>Shows what a fix has done.</summary>
        public void Show(FixOutcome outcome) => m_Answer = outcome.Message;

        /// <summary>Takes the next lines of the inspector.</summary>
        /// <returns>Whether something was mended.</returns>
        public bool Draw()
        {
            bool mended = false;
            if (m_Status.IsShown)
            {
                EditorGUILayout.HelpBox(m_Status.Message, m_Status.Kind);
                mended = DrawFixes();
            }

            if (!string.IsNullOrEmpty(m_Answer))
                EditorGUILayout.LabelField(m_Answer, EditorStyles.wordWrappedMiniLabel);
            return mended;
        }

        private bool DrawFixes()
        {
            IReadOnlyList<InsectFix> fixes = InsectFixes.For(m_Status.Insect, m_Status.Problem);
            if (fixes.Count == 0)
                return false;
            InsectFix pressed = null;
            using (new EditorGUILayout.HorizontalScope())
            {
                foreach (InsectFix fix in fixes)
                {
                    string obstacle = fix.FindObstacle(m_Status.Insect, m_Status.Problem);
                    using (new EditorGUI.DisabledScope(obstacle != null))
                    {
                        if (GUILayout.Button(new GUIContent(fix.Label, obstacle ?? fix.Tooltip)))
                            pressed = fix;
                    }
                }
            }

            foreach (InsectFix fix in fixes)
            {
                string obstacle = fix.FindObstacle(m_Status.Insect, m_Status.Problem);
                if (obstacle != null)
                    EditorGUILayout.LabelField(obstacle, EditorStyles.wordWrappedMiniLabel);
            }

            if (pressed == null)
                return false;
            FixOutcome outcome = pressed.Apply(m_Status.Insect, m_Status.Problem);
            Show(outcome);
            return outcome.IsDone;
        }
    }
}
