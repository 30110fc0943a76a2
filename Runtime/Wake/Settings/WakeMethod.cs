namespace Alate.Wake
{
    /// <summary>The ways to find the circulation of a wing that sheds a wake.</summary>
    public enum WakeMethod
    {
        /// <summary>
        /// One ring a strip of the wing; its circulation is that of the lift coefficients in the air that the strip meets, wake included: a
        /// nonlinear lifting line with a free wake.
        /// </summary>
        Strips,

        /// <summary>
        /// A lattice of rings on a thin wing that no air crosses, with pressure, and with the suction of the leading edge turned into the
        /// normal (extended unsteady vortex lattice). Uses no measured coefficient, and has neither friction nor stall.
        /// </summary>
        Panels,
    }
}
