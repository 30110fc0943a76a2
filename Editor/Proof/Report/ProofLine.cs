using System;

namespace Alate.Proof
{
    /// <summary>One claim of a proof, and what came of it.</summary>
    [Serializable]
    internal sealed class ProofLine
    {
        /// <summary>The claim, a few words.</summary>
        public string what;

        /// <summary>Outcome.</summary>
        public ProofState state;

        /// <summary>Measured number or text with its unit; empty where nothing was.</summary>
        public string measured = "";

        /// <summary>Largest or expected number with its unit; empty where there is none.</summary>
        public string allowed = "";

        /// <summary>Place where it is worst, reason why it was not tried, or first error; empty where there is nothing to say.</summary>
        public string note = "";

        /// <summary>A line that was measured.</summary>
        public static ProofLine Of(string what, bool held, string measured, string allowed = "", string note = "") => new ProofLine
        {
            what = what,
            state = held ? ProofState.Held : ProofState.Differs,
            measured = measured,
            allowed = allowed,
            note = note,
        };

        /// <summary>A line of which nothing is known.</summary>
        public static ProofLine NotTried(string what, string reason = "") => new ProofLine { what = what, note = reason };
    }
}
