using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Fills the list of wings with those found below the insect; settings of wings that stay are kept.</summary>
    internal sealed class FindWingsFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Find Wings";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Looks for wings below this object, by the names of objects, meshes and materials and by symmetry. "
            + "Wings already in the list keep their settings; entries without a renderer, or for other parts of what is found, go. "
            + "Can be undone.";

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            List<Wing> found = WingFinder.Find(insect.transform);
            if (found.Count == 0)
                return FixOutcome.Refused(NothingFound(insect));
            Edits.Change(insect, Label, changed =>
            {
                List<Wing> merged = WingList.Merge(changed.Wings, found);
                changed.Wings.Clear();
                changed.Wings.AddRange(merged);
            });
            return FixOutcome.Done(found.Count == 1 ? "Found one wing." : $"Found {found.Count} wings.");
        }

        private static string NothingFound(InsectWings insect) =>
            insect.GetComponentInChildren<MeshRenderer>(true) == null
                ? $"There is no MeshRenderer below '{insect.name}'. Put the insect's meshes below it, or move the component to the "
                    + "object above them."
                : $"No mesh below '{insect.name}' is called a wing, and none has a mirror image. Add the wings by hand.";
    }
}
