namespace Alate.Editor
{
    /// <summary>Remedy for a problem of an insect, offered by a button of the inspector. Can be undone as far as Unity allows.</summary>
    internal abstract class InsectFix
    {
        /// <summary>Text on the button, and in the undo menu.</summary>
        public abstract string Label { get; }

        /// <summary>Text that tells what the fix changes, and whether that can be undone.</summary>
        public abstract string Tooltip { get; }

        /// <summary>Reason why the fix cannot be applied now; null when it can.</summary>
        public virtual string FindObstacle(InsectWings insect, in InsectProblem problem) => null;

        /// <summary>Applies the fix.</summary>
        public abstract FixOutcome Apply(InsectWings insect, in InsectProblem problem);
    }
}
