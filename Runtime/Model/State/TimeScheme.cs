namespace Alate
{
    /// <summary>Scheme by which a substep advances bends and membrane. Both schemes are implicit and cost equally much.</summary>
    public enum TimeScheme
    {
        /// <summary>
        /// Backward differences over two substeps (BDF2), with surface, torque arms and frames carried to the end of the substep: the error
        /// falls with the square of the substep. The default.
        /// </summary>
        SecondOrder,

        /// <summary>Backward Euler, as in Eq. 13: the error falls with the substep itself.</summary>
        BackwardEuler,
    }
}
