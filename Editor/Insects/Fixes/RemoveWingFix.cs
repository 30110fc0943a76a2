namespace Alate.Editor
{
    /// <summary>Takes the wing that has the problem off the list.</summary>
    internal sealed class RemoveWingFix : InsectFix
    {
        /// <inheritdoc/>
        public override string Label => "Remove Wing";

        /// <inheritdoc/>
        public override string Tooltip => "Takes this wing off the list. Renderer and mesh stay as they are. Can be undone.";

        /// <inheritdoc/>
        public override FixOutcome Apply(InsectWings insect, in InsectProblem problem)
        {
            int wing = problem.Wing;
            if (wing < 0 || wing >= insect.Wings.Count)
                return FixOutcome.Refused($"'{insect.name}' has no wing {wing} any more.");
            Edits.Change(insect, Label, changed => changed.Wings.RemoveAt(wing));
            return FixOutcome.Done();
        }
    }
}
