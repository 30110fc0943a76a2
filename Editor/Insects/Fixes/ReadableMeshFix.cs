using System.Collections.Generic;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Makes all wing meshes readable that come from models; names the remedy for the others.</summary>
    internal sealed class ReadableMeshFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Make Mesh Readable";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Turns on Read/Write in the import settings of the models that the wings of this insect come from, and imports them again.";

        /// <inheritdoc/>
        public override string FindObstacle(InsectWings insect, in InsectProblem problem)
        {
            Sort(insect, out List<Mesh> mendable, out string obstacle);
            return mendable.Count > 0 ? null : obstacle;
        }

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            Sort(insect, out List<Mesh> mendable, out string obstacle);
            if (mendable.Count == 0)
                return FixOutcome.Refused(obstacle ?? "All meshes are readable.");
            MeshImport.MakeReadable(mendable, Label);
            return FixOutcome.Done(obstacle ?? "");
        }

        private static void Sort(InsectWings insect, out List<Mesh> mendable, out string obstacle)
        {
            mendable = new List<Mesh>();
            obstacle = null;
            foreach (Wing wing in insect.Wings)
            {
                Mesh mesh = wing == null ? null : InsectCheck.MeshOf(wing, InsectCheck.FilterOf(wing));
                if (mesh == null || mesh.isReadable)
                    continue;
                string found = MeshImport.FindObstacle(mesh);
                if (found == null)
                    mendable.Add(mesh);
                else
                    obstacle = found;
            }
        }
    }
}
