using Unity.Mathematics;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>State of a wing at one time of its beat.</summary>
    [MovedFrom(true, null, "Alate")]
    public readonly struct BeatFrame
    {
        /// <summary>A frame of the given content; the array is kept, not copied.</summary>
        public BeatFrame(float phase, quaternion root, float3[] positions)
        {
            Phase = phase;
            Root = root;
            Positions = positions;
        }

        /// <summary>Phase Φ, radians.</summary>
        public float Phase { get; }

        /// <summary>Rotation by which the muscles turn the root of the leading edge out of its rest pose, about the hinge.</summary>
        public quaternion Root { get; }

        /// <summary>[vertex] Deformed position, wing frame, wing lengths.</summary>
        public float3[] Positions { get; }

        /// <summary>Position of a place of the wing in the frame of its root: as if the root stood still.</summary>
        public float3 AtRoot(float3 position) => math.rotate(math.conjugate(Root), position);
    }
}
