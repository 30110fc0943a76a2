namespace Alate.Editor
{
    /// <summary>Whether an act was done, and if not, why not.</summary>
    internal readonly struct EditOutcome
    {
        private EditOutcome(bool done, string message)
        {
            Done = done;
            Message = message;
        }

        /// <summary>The act was done.</summary>
        public static EditOutcome Success => new EditOutcome(true, null);

        public bool Done { get; }

        /// <summary>One sentence for the user where the act was refused, else null.</summary>
        public string Message { get; }

        public static EditOutcome Refused(string why) => new EditOutcome(false, why);

        public override string ToString() => Done ? "done" : Message;
    }
}
