using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Offers skeletons for wings of the selected insects that have none.</summary>
    internal static class SkeletonMakerGui
    {
        private static readonly InsectFix s_LayOut = new LayOutSkeletonFix(LayOutSkeletonFix.Fit, AssetPath.Ask);

        /// <summary>Draws the next lines of the panel.</summary>
        /// <returns>What became of it where the button was pressed, else null.</returns>
        public static EditOutcome? Draw()
        {
            foreach (GameObject chosen in Selection.gameObjects)
            {
                if (!chosen.TryGetComponent(out InsectWings insect) || InsectTargets.WithoutSkeleton(insect).Count == 0)
                    continue;
                if (!GUILayout.Button(new GUIContent($"Lay Out '{insect.name}'…", s_LayOut.Tooltip)))
                    continue;
                FixOutcome outcome = s_LayOut.Apply(insect, InsectProblem.None);
                return string.IsNullOrEmpty(outcome.Message) ? EditOutcome.Success : EditOutcome.Refused(outcome.Message);
            }

            return null;
        }
    }
}
