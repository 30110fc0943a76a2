using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>Which loads turn a joint, and about which point (Eq. 4).</summary>
    [MovedFrom(true, null, "Alate")]
    public enum TorqueArm
    {
        /// <summary>
        /// The loads of all joints farther out on the chain, about the joint itself: what a cantilever's cross-section carries. The default.
        /// </summary>
        DistalJoints,

        /// <summary>The joint's own load about the root of its chain, as printed; what hangs farther out does not bend the joint.</summary>
        OwnLoadAboutRoot,
    }
}
