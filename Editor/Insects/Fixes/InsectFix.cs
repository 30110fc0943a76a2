namespace Alate.Editor
{
    /// <summary>Something a button in the inspector can do about a problem of an insect. Can be undone as far as Unity allows.</summary>
    internal abstract class InsectFix
    {
        /// <summary>On the button, and in the undo menu.</summary>
        public abstract string Label { get; }

        /// <summary>What it will change, and whether that can be undone.</summary>
        public abstract string Tooltip { get; }

        /// <summary>Why it cannot be done at the moment; null when it can.</summary>
        public virtual string FindObstacle(InsectWings insect, in InsectProblem problem) => null;

        /// <summary>Does it.</summary>
        public abstract FixOutcome Apply(InsectWings insect, in InsectProblem problem);
    }
}
