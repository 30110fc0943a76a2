namespace Alate.Samples
{
    /// <summary>One choice between two columns that somebody made.</summary>
    internal readonly struct Vote
    {
        public Vote(string participant, string species, string left, string right, string chosen)
        {
            Participant = participant;
            Species = species;
            Left = left;
            Right = right;
            Chosen = chosen;
        }

        /// <summary>Name of the participant; tells nothing of the person.</summary>
        public string Participant { get; }

        /// <summary>Name of the species that was shown.</summary>
        public string Species { get; }

        /// <summary>The column on the left.</summary>
        public string Left { get; }

        /// <summary>The column on the right.</summary>
        public string Right { get; }

        /// <summary>One of the two.</summary>
        public string Chosen { get; }

        /// <summary>Returns true where the vote is about these two columns.</summary>
        public bool IsBetween(string one, string other) => (Left == one && Right == other) || (Left == other && Right == one);
    }
}
