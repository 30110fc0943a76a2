using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Reading of the paper that a wing follows. Every option that a reading sets can also be set on its own.</summary>
    [MovedFrom(true, null, "Alate", "ModelPreset")]
    public enum ModelReading
    {
        /// <summary>Reading with the open signs, units and steps resolved so that the wing behaves like a wing. The default.</summary>
        Physical,

        /// <summary>
        /// Reading of the equations as printed, for comparison; the wing lags by half a beat and tears at its trailing edge.
        /// </summary>
        Paper,
    }
}
