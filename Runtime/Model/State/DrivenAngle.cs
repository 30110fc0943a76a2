namespace Alate
{
    /// <summary>Angles of a wing's drive at the root.</summary>
    public enum DrivenAngle
    {
        /// <summary>Angle in the stroke plane, up positive.</summary>
        Flap,

        /// <summary>Angle out of the stroke plane, ahead positive: a constant sweep is a coning angle.</summary>
        Sweep,

        /// <summary>Angle about the leading edge, nose down positive.</summary>
        Feather,

        /// <summary>Angle of the stroke plane about the span axis, nose up positive; 0 is upright.</summary>
        Tilt,
    }
}
