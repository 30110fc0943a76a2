using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Which reading of the paper a wing follows. Everything a preset sets can also be set by itself.</summary>
    [MovedFrom(true, null, "Alate", "ModelPreset")]
    public enum ModelReading
    {
        /// <summary>The equations with their open signs, units and steps resolved so that the wing behaves like a wing. The default.</summary>
        Physical,

        /// <summary>The equations as they are printed, for comparison; the wing lags by half a beat and tears at its trailing edge.</summary>
        Paper,
    }
}
