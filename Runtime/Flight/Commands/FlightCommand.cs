using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Command of a pilot: a velocity, where to look, and whether to land. The wings alone act on it.</summary>
    public struct FlightCommand
    {
        /// <summary>Wanted velocity over ground, m/s along the world's axes; limited to what the insect can do.</summary>
        public float3 velocity;

        /// <summary>
        /// Wanted heading, radians about the world's up; 0 looks along +Z, π/2 along +X. Not a number leaves it to the flight: along the
        /// way where the insect moves, as it is where it hovers. Above 0.3 m/s, or a quarter of its top speed where that is less, the
        /// insect looks along its way through the air whatever is wanted.
        /// </summary>
        public float heading;

        /// <summary>Wish besides flying on.</summary>
        public FlightWish wish;

        /// <summary>
        /// Spot to sit on, with <see cref="FlightWish.Land"/>. Of an insect that sits: where its spot is by now. What moves takes it along;
        /// what is more than 0.2 m off in a step is another spot, and does not.
        /// </summary>
        public PerchSpot spot;

        /// <summary>Flight at a velocity over ground, m/s along the world's axes; the heading follows the way.</summary>
        public static FlightCommand Fly(float3 velocity) => new FlightCommand { velocity = velocity, heading = float.NaN };

        /// <summary>Flight at a velocity over ground, m/s, looking along a heading, radians.</summary>
        public static FlightCommand Fly(float3 velocity, float heading) => new FlightCommand { velocity = velocity, heading = heading };
    }
}
