namespace Alate
{
    /// <summary>Source of the velocity of an insect's body.</summary>
    public enum VelocitySource
    {
        /// <summary>Motion of the transform.</summary>
        Transform,

        /// <summary>Velocity of the Rigidbody.</summary>
        Rigidbody,

        /// <summary>Velocity that a script sets in <see cref="InsectWings.Velocity"/>.</summary>
        Script,
    }
}
