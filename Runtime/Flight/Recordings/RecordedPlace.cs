using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Place of a wing on a body in a scene, where it differs from the catalogue's by rounding.</summary>
    internal struct RecordedPlace
    {
        /// <summary>Hinge from the middle of the thorax in body axes, metres.</summary>
        public float3 hinge;

        /// <summary>Directions of the wing's frame in body axes.</summary>
        public float3x3 axes;
    }
}
