using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Situation of an insect whose pilot is asked for a command: the body in the world, the air, the time and the insect's limits.
    /// </summary>
    /// <remarks>
    /// Lengths are metres of the real insect along the world's axes, times its scale in the scene: <see cref="unitsPerMetre"/> turns metres
    /// into world units.
    /// </remarks>
    public struct FlightSituation
    {
        /// <summary>Centre of mass, world units.</summary>
        public float3 position;

        /// <summary>Rotation of the body, X right, Y up, Z ahead.</summary>
        public quaternion rotation;

        /// <summary>Velocity of the centre of mass, m/s along the world's axes; it bobs with the beat.</summary>
        public float3 velocity;

        /// <summary>Turning of the body about the world's axes, rad/s; it bobs with the beat.</summary>
        public float3 angularVelocity;

        /// <summary>Velocity of the air as the insect senses it (smoothed over 0.1 s), m/s along the world's axes.</summary>
        public float3 wind;

        /// <summary>Velocity that the controller follows now, m/s; free of the bobbing.</summary>
        public float3 referenceVelocity;

        /// <summary>Heading that the controller follows now, radians about the world's up; 0 looks along +Z, π/2 along +X.</summary>
        public float heading;

        /// <summary>State of the flight.</summary>
        public FlightState state;

        /// <summary>Limits of the insect's flight.</summary>
        public FlightLimits limits;

        /// <summary>Seconds that the insect has flown, in all its flights.</summary>
        public double time;

        /// <summary>Seconds of the step for which the command holds.</summary>
        public float deltaTime;

        /// <summary>Length of the insect's longest wing, metres.</summary>
        public float wingLength;

        /// <summary>World units of a metre of the real insect.</summary>
        public float unitsPerMetre;
    }
}
