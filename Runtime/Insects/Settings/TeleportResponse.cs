namespace Alate
{
    /// <summary>Response of the wings when an insect jumps to another place.</summary>
    public enum TeleportResponse
    {
        /// <summary>The wings beat on without feeling the jump.</summary>
        Keep,

        /// <summary>The wings restart at <see cref="InsectWings.StartPhase"/>, unbent.</summary>
        Reset,

        /// <summary>No move counts as a jump up to 1000 m/s of the real insect: the wings feel it as motion.</summary>
        Ignore,
    }
}
