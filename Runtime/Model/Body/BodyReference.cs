using Unity.Mathematics;

namespace Alate
{
    /// <summary>Reference of the feedback at the beat: set once a fixed step, carried on with its rates in between.</summary>
    internal struct BodyReference
    {
        /// <summary>Velocity over ground along the world's axes, m/s, and its rate, m/s².</summary>
        public float3 velocity, acceleration;

        /// <summary>Heading about the world's up, radians, and its rate, rad/s.</summary>
        public float heading, turning;

        /// <summary>Speed ahead through the air and climb, m/s: the place in the table.</summary>
        public float airSpeed, climb;
    }
}
