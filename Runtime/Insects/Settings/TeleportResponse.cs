namespace Alate
{
    /// <summary>What happens when an insect jumps to another place.</summary>
    public enum TeleportResponse
    {
        /// <summary>The wings beat on as if nothing had happened.</summary>
        Keep,

        /// <summary>The wings start over, at <see cref="InsectWings.StartPhase"/>, unbent.</summary>
        Reset,

        /// <summary>No move counts as a jump: the wings feel it as motion.</summary>
        Ignore,
    }
}
