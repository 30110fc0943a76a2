using System.Collections.Generic;
using Alate.Fitting;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>
    /// Lays out new skeletons, saves them as assets and assigns them: to the wing that has the problem, or to all wings without one.
    /// </summary>
    internal sealed class LayOutSkeletonFix : InsectFix
    {
        private readonly FitSkeleton m_Fit;
        private readonly AskForPath m_Ask;

        /// <param name="fit">How chains are laid out.</param>
        /// <param name="ask">Where to save them.</param>
        public LayOutSkeletonFix(FitSkeleton fit, AskForPath ask)
        {
            m_Fit = fit;
            m_Ask = ask;
        }

        /// <summary>Fits a skeleton as at the beginning of play.</summary>
        public static SkeletonFit Fit(SurfaceMesh surface, Transform insect, Transform mesh) =>
            new AutomaticSkeleton(insect, mesh).Fit(surface);

        /// <inheritdoc/>
        public override string Label => "Lay Out Skeleton…";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Lays out joint chains on the mesh, saves them as an asset where you choose and assigns it. Wings of the same mesh share one. "
            + "Undo takes the assignment back; the asset stays.";

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            List<int> chosen = Choose(insect, problem);
            if (chosen.Count == 0)
                return FixOutcome.Refused("All wings have a skeleton.");
            using (var layout = SkeletonLayout.Of(insect, chosen, m_Fit))
            {
                string notes = string.Join(" ", layout.Notes);
                if (layout.Count == 0)
                    return FixOutcome.Refused(notes);
                string path = m_Ask(
                    "Save Wing Skeleton", AssetPath.FileName(insect.name + " Skeleton"), "Choose where the new skeleton is saved.");
                if (string.IsNullOrEmpty(path))
                    return FixOutcome.Refused("");
                string obstacle = AssetPath.FindProblem(path);
                if (obstacle != null)
                    return FixOutcome.Refused(obstacle);
                Assign(insect, layout.Save(path, Label));
                return FixOutcome.Done(notes);
            }
        }

        private void Assign(InsectWings insect, Dictionary<int, WingSkeleton> skeletons)
        {
            Edits.Change(insect, Label, changed =>
            {
                foreach (KeyValuePair<int, WingSkeleton> made in skeletons)
                    changed.Wings[made.Key].Skeleton = made.Value;
            });
        }

        private static List<int> Choose(InsectWings insect, in InsectProblem problem)
        {
            if (problem.Wing >= 0 && problem.Wing < insect.Wings.Count)
                return new List<int> { problem.Wing };
            var chosen = new List<int>();
            for (int w = 0; w < insect.Wings.Count; w++)
            {
                if (insect.Wings[w] != null && insect.Wings[w].Skeleton == null)
                    chosen.Add(w);
            }

            return chosen;
        }
    }
}
