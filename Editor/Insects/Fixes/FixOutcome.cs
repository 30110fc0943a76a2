namespace Alate.Editor
{
    /// <summary>Outcome of a fix: success, or the reason for a refusal.</summary>
    internal readonly struct FixOutcome
    {
        private FixOutcome(bool isDone, string message)
        {
            IsDone = isDone;
            Message = message;
        }

        /// <summary>True where something was changed.</summary>
        public bool IsDone { get; }

        /// <summary>Message of one or two sentences for the user; empty when there is nothing to add.</summary>
        public string Message { get; }

        /// <summary>Outcome of a fix that worked.</summary>
        public static FixOutcome Done(string message = "") => new FixOutcome(true, message);

        /// <summary>Outcome of a fix that changed nothing.</summary>
        public static FixOutcome Refused(string reason) => new FixOutcome(false, reason);
    }
}
