using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Motion that the body was given between two steps by contacts, or by who placed the object elsewhere.</summary>
    internal struct RecordedPush
    {
        /// <summary>Number of the step before which it came, from 0.</summary>
        public int step;

        /// <summary>Rotation of the body after it.</summary>
        public quaternion rotation;

        /// <summary>Velocity after it, m/s.</summary>
        public float3 velocity;

        /// <summary>Turning after it about the body's axes, rad/s.</summary>
        public float3 spin;

        /// <summary>Turn of the reference about the world's up, radians.</summary>
        public float turn;
    }
}
