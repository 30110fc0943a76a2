namespace Alate.Editor
{
    /// <summary>What the colours of an inspected wing mean.</summary>
    internal enum RigColourMode
    {
        /// <summary>How strongly the selected joints move each place: dark not at all, light entirely.</summary>
        JointWeight,

        /// <summary>The masses of the joints around: light where a joint is as heavy as the heaviest.</summary>
        JointMass,

        /// <summary>How late the wave arrives: dark at once, light last.</summary>
        Delay,

        /// <summary>A colour for each surface patch that meets the air.</summary>
        Patch,
    }
}
