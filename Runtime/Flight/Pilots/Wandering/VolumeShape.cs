namespace Alate.Flight
{
    /// <summary>Shape of a volume in which insects stay.</summary>
    public enum VolumeShape
    {
        /// <summary>A box along the world's axes.</summary>
        Box,

        /// <summary>An ellipsoid along the world's axes; a ball where the three sizes are equal.</summary>
        Ellipsoid,
    }
}
