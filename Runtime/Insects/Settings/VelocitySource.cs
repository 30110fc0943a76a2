namespace Alate
{
    /// <summary>Where the velocity of an insect's body comes from.</summary>
    public enum VelocitySource
    {
        /// <summary>From how its transform moves.</summary>
        Transform,

        /// <summary>From its Rigidbody.</summary>
        Rigidbody,

        /// <summary>A script sets <see cref="InsectWings.Velocity"/>.</summary>
        Script,
    }
}
