namespace Alate.Proof
{
    /// <summary>Outcome of a line of a proof.</summary>
    internal enum ProofState
    {
        /// <summary>Nothing was measured.</summary>
        NotTried,

        /// <summary>Measured, and within what is allowed.</summary>
        Held,

        /// <summary>Measured, and outside of what is allowed, or failed.</summary>
        Differs,
    }
}
