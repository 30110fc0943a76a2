using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Loads that turn a joint, and the point about which they turn it (Eq. 4).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum TorqueArm
    {
        /// <summary>
        /// The loads of all joints farther out on the chain, about the joint itself: what a cantilever's cross-section carries. The
        /// default.
        /// </summary>
        DistalJoints,

        /// <summary>The joint's own load about the root of its chain, as printed; what hangs farther out does not bend the joint.</summary>
        OwnLoadAboutRoot,
    }
}
