using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Transition of frequency and amplitude from one cycle's values to the next (Eq. 6 and 7 set them once per cycle).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum CycleChange
    {
        /// <summary>
        /// Stroke numbers move over the first half of the new cycle by 3x² − 2x³, so that angle and angular rate are continuous. The
        /// default.
        /// </summary>
        Smooth,

        /// <summary>
        /// Stroke numbers jump at the start of the cycle, as printed. With a phase other than 0 the wing jumps with them.
        /// </summary>
        Step,
    }
}
