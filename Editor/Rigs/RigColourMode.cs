namespace Alate.Editor
{
    /// <summary>Meaning of the colours of an inspected wing.</summary>
    internal enum RigColourMode
    {
        /// <summary>Weight of the selected joints at each place: dark not at all, light entirely.</summary>
        JointWeight,

        /// <summary>Masses of the joints around a place: light where a joint is as heavy as the heaviest.</summary>
        JointMass,

        /// <summary>Delay of the wave: dark at once, light last.</summary>
        Delay,

        /// <summary>A colour for each surface patch that meets the air.</summary>
        Patch,
    }
}
