using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace Alate.Editor
{
    /// <summary>Turns off Batching Static on all wings of an insect: a mesh that was merged with others cannot be deformed.</summary>
    internal sealed class StaticBatchingFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Turn Off Batching Static";

        /// <inheritdoc/>
        public override string Tooltip =>
            "Turns off Batching Static on the objects of all wings of this insect; their other static flags stay. Can be undone.";

        /// <summary>The first wing that static batching would merge; −1 for none.</summary>
        public static int FindFlagged(InsectWings insect) => insect.Wings.FindIndex(wing => IsFlagged(wing));

        /// <inheritdoc/>
        public override string FindObstacle(InsectWings insect, in InsectProblem problem) =>
            Application.IsPlaying(insect) ? "The meshes of this play session are merged already. Stop playing first." : null;

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            var flagged = new HashSet<GameObject>();
            foreach (Wing wing in insect.Wings)
            {
                if (IsFlagged(wing))
                    flagged.Add(wing.Renderer.gameObject);
            }

            if (flagged.Count == 0)
            {
                return FixOutcome.Refused("Batching Static is off on all wings. Something else merges their meshes, such as "
                    + "StaticBatchingUtility.Combine in a script.");
            }
            Edits.InOneStep(Label, () =>
            {
                foreach (GameObject wing in flagged)
                    Edits.Change(wing, Label, TurnOff);
            });
            return FixOutcome.Done();
        }

        private static void TurnOff(GameObject wing) =>
            GameObjectUtility.SetStaticEditorFlags(wing, GameObjectUtility.GetStaticEditorFlags(wing) & ~StaticEditorFlags.BatchingStatic);

        private static bool IsFlagged(Wing wing) =>
            wing != null && wing.Renderer != null
            && (GameObjectUtility.GetStaticEditorFlags(wing.Renderer.gameObject) & StaticEditorFlags.BatchingStatic) != 0;
    }
}
