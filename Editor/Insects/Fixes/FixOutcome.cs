namespace Alate.Editor
{
    /// <summary>What a fix has done, or why it has not.</summary>
    internal readonly struct FixOutcome
    {
        private FixOutcome(bool isDone, string message)
        {
            IsDone = isDone;
            Message = message;
        }

        /// <summary>Whether something was changed.</summary>
        public bool IsDone { get; }

        /// <summary>One or two sentences for the user; empty when there is nothing to add to what he sees.</summary>
        public string Message { get; }

        /// <summary>Outcome of a fix that worked.</summary>
        public static FixOutcome Done(string message = "") => new FixOutcome(true, message);

        /// <summary>Nothing was changed.</summary>
        public static FixOutcome Refused(string reason) => new FixOutcome(false, reason);
    }
}
