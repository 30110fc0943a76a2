using UnityEditor;

namespace Alate.Editor
{
    /// <summary>Shows the skeleton of the wing that has the problem in the inspector, where its problems are listed.</summary>
    internal sealed class OpenSkeletonFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Open Skeleton";

        /// <inheritdoc/>
        public override string Tooltip => "Selects the skeleton, so that the inspector lists all its problems. Changes nothing.";

        /// <inheritdoc/>
        public override string FindObstacle(InsectWings insect, in InsectProblem problem) =>
            SkeletonOf(insect, problem) == null ? "The wing has no skeleton." : null;

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            WingSkeleton skeleton = SkeletonOf(insect, problem);
            if (skeleton == null)
                return FixOutcome.Refused(FindObstacle(insect, problem));
            Selection.activeObject = skeleton;
            EditorGUIUtility.PingObject(skeleton);
            return FixOutcome.Done();
        }

        private static WingSkeleton SkeletonOf(InsectWings insect, in InsectProblem problem) =>
            problem.Wing >= 0 && problem.Wing < insect.Wings.Count ? insect.Wings[problem.Wing]?.Skeleton : null;
    }
}
