namespace Alate
{
    /// <summary>Angles of a wing's drive at the root.</summary>
    public enum DrivenAngle
    {
        /// <summary>In the stroke plane, up positive.</summary>
        Flap,

        /// <summary>Out of the stroke plane, ahead positive: a constant sweep is a coning angle.</summary>
        Sweep,

        /// <summary>About the leading edge, nose down positive.</summary>
        Feather,

        /// <summary>Of the stroke plane about the span axis, nose up positive; 0 is upright.</summary>
        Tilt,
    }
}
