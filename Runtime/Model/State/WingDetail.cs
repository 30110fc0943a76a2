using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Level of detail of a wing's computation; each level is cheaper than the one before. A wing may change level at any time without a
    /// jump.
    /// </summary>
    [MovedFrom(true, null, "Alate")]
    public enum WingDetail
    {
        /// <summary>Full model, as the parameters say.</summary>
        Full,

        /// <summary>
        /// Half the substeps, but not fewer than <see cref="WingParameters.MinSubsteps"/> a beat; all of them where the beat is commanded,
        /// as in flight.
        /// </summary>
        FewerSubsteps,

        /// <summary>Fewer substeps, and only <see cref="WingRigSettings.CoarsePatches"/> patches meet the air.</summary>
        CoarsePatches,

        /// <summary>Driven waves alone (Eq. 1–3, 6–7); bends and stretches fade within a quarter of a beat. Air force reads 0.</summary>
        WavesOnly,

        /// <summary>No computation; the wing keeps its pose until its level changes.</summary>
        Frozen,
    }
}
