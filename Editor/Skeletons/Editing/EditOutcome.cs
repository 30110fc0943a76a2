namespace Alate.Editor
{
    /// <summary>Outcome of a command: success, or the reason for a refusal.</summary>
    internal readonly struct EditOutcome
    {
        private EditOutcome(bool done, string message)
        {
            Done = done;
            Message = message;
        }

        /// <summary>Outcome of a command that was done.</summary>
        public static EditOutcome Success => new EditOutcome(true, null);

        public bool Done { get; }

        /// <summary>Sentence for the user where the command was refused, else null.</summary>
        public string Message { get; }

        public static EditOutcome Refused(string why) => new EditOutcome(false, why);

        public override string ToString() => Done ? "done" : Message;
    }
}
