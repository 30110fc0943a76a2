using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Direction of the surface against which the angle of attack is measured (Eq. 10).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum AirTangent
    {
        /// <summary>
        /// The part of the air's velocity that lies in the surface and across the span. Flow along the span makes neither lift nor drag
        /// (strip theory), so it is taken out first. The default.
        /// </summary>
        Chordwise,

        /// <summary>
        /// The base-to-tip direction, as printed. A beating wing moves across its span, so nearly every element then stands near 90° in
        /// hover: much drag and hardly any lift.
        /// </summary>
        BaseToTip,
    }
}
