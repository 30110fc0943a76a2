using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Unit of the elasticity k_e in the spring energy (Eq. 12).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum SpringUnits
    {
        /// <summary>
        /// k = k_e κ (2π f_ref)² per wing mass: the springs keep pace with the beat, whatever the insect's size and frequency. The default.
        /// </summary>
        BeatRate,

        /// <summary>
        /// k = k_e per wing mass and second squared, as printed. At the paper's k_e near 1 such a spring takes six seconds to swing once,
        /// so that it does nothing during a beat.
        /// </summary>
        Printed,
    }
}
