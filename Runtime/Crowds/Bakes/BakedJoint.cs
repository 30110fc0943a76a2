using Unity.Mathematics;

namespace Alate.Crowds
{
    /// <summary>Pose of a joint of a wing at one frame, in the insect's own space.</summary>
    public readonly struct BakedJoint
    {
        /// <summary>Position.</summary>
        public readonly float3 position;

        /// <summary>Rotation out of the rest pose.</summary>
        public readonly quaternion rotation;

        internal BakedJoint(float3 position, quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }
    }
}
