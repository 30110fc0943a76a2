using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Help box of the inspector, with a button for each fix, and the answer of the last fix.</summary>
    internal sealed class StatusBox
    {
        /// <summary>
        /// Time, seconds, after which insects are checked again even if they are unchanged: finding wings in large meshes takes time.
        /// </summary>
        private const double k_Patience = 0.5;

        private readonly List<(InsectFix fix, string obstacle)> m_Fixes = new List<(InsectFix, string)>();
        private IReadOnlyList<InsectWings> m_Insects = System.Array.Empty<InsectWings>();
        private InsectStatus m_Status;
        private string m_Answer = "";
        private double m_Looked = double.NegativeInfinity;

        /// <summary>Checks the selected insects; a changed status clears the last answer.</summary>
        /// <param name="insects">All that are selected.</param>
        /// <param name="changed">Whether they have been changed since the last look.</param>
        public void Refresh(IReadOnlyList<InsectWings> insects, bool changed)
        {
            double now = EditorApplication.timeSinceStartup;
            if (!changed && now - m_Looked < k_Patience)
                return;
            m_Looked = now;
            m_Insects = insects;
            var status = InsectStatus.Of(insects);
            if (status.Message != m_Status.Message && status.IsShown)
                m_Answer = "";
            m_Status = status;
            m_Fixes.Clear();
            if (!status.IsShown)
                return;
            foreach (InsectFix fix in InsectFixes.For(status.Insect, status.Problem))
                m_Fixes.Add((fix, fix.FindObstacle(status.Insect, status.Problem)));
        }

        /// <summary>Shows what a fix has done.</summary>
        public void Show(FixOutcome outcome) => m_Answer = outcome.Message;

        /// <summary>Draws the next lines of the inspector.</summary>
        /// <returns>Whether a fix was tried: what is drawn of this event is then out of date, also where a dialog was closed.</returns>
        public bool Draw()
        {
            bool tried = false;
            if (m_Status.IsShown)
            {
                EditorGUILayout.HelpBox(m_Status.Message, m_Status.Kind);
                tried = DrawFixes();
            }

            if (!string.IsNullOrEmpty(m_Answer))
                EditorGUILayout.LabelField(m_Answer, EditorStyles.wordWrappedMiniLabel);
            return tried;
        }

        private bool DrawFixes()
        {
            if (m_Fixes.Count == 0)
                return false;
            InsectFix pressed = null;
            using (new EditorGUILayout.HorizontalScope())
            {
                foreach ((InsectFix fix, string obstacle) in m_Fixes)
                {
                    using (new EditorGUI.DisabledScope(obstacle != null))
                    {
                        if (GUILayout.Button(new GUIContent(fix.Label, obstacle ?? fix.Tooltip)))
                            pressed = fix;
                    }
                }
            }

            foreach ((InsectFix _, string obstacle) in m_Fixes)
            {
                if (obstacle != null)
                    EditorGUILayout.LabelField(obstacle, EditorStyles.wordWrappedMiniLabel);
            }

            if (pressed == null)
                return false;
            Apply(pressed);
            return true;
        }

        // All selected insects with the same problem are mended at once.
        private void Apply(InsectFix fix)
        {
            InsectState state = m_Status.Problem.State;
            FixOutcome last = default;
            Edits.InOneStep(fix.Label, () =>
            {
                foreach (InsectWings insect in m_Insects)
                {
                    InsectProblem problem = insect == null ? InsectProblem.None : InsectStatus.FindProblem(insect);
                    if (problem.State != state || fix.FindObstacle(insect, problem) != null)
                        continue;
                    last = fix.Apply(insect, problem);
                }
            });
            m_Answer = last.Message;
        }
    }
}
