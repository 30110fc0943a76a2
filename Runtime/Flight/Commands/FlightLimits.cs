using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>
    /// Limits of an insect's flight by its trim table and its reference model, within which a pilot may ask. Metres and seconds of the real
    /// insect.
    /// </summary>
    public readonly struct FlightLimits
    {
        /// <summary>Largest change of the wanted velocity of insects that fly, m/s²; those that swim have less.</summary>
        internal const float FlyersAcceleration = 2.5f;

        /// <summary>Seconds until the body follows a change of the wanted velocity.</summary>
        private const float k_Response = 0.2f;

        /// <param name="topSpeed">Fastest flight through the air, m/s.</param>
        /// <param name="leastClimb">Fastest descent, m/s, below 0.</param>
        /// <param name="mostClimb">Fastest climb, m/s.</param>
        /// <param name="acceleration">Of the reference, m/s².</param>
        public FlightLimits(float topSpeed, float leastClimb, float mostClimb, float acceleration)
        {
            TopSpeed = topSpeed;
            LeastClimb = leastClimb;
            MostClimb = mostClimb;
            Acceleration = acceleration;
        }

        /// <summary>Fastest flight through the air, m/s; faster wind carries the insect away.</summary>
        public float TopSpeed { get; }

        /// <summary>Fastest descent, m/s, below 0.</summary>
        public float LeastClimb { get; }

        /// <summary>Fastest climb, m/s. Slow flight may climb less.</summary>
        public float MostClimb { get; }

        /// <summary>Largest change of the wanted velocity that the insect follows, m/s².</summary>
        public float Acceleration { get; }

        /// <summary>
        /// Metres from a speed to standing in the air: v²/2a and what it flies before it answers; 0.6 m from 1.3 m/s for a monarch.
        /// </summary>
        public float StoppingDistance(float speed) => speed * speed / (2f * Acceleration) + k_Response * math.abs(speed);

        /// <summary>
        /// Fastest speed, m/s, from which <see cref="StoppingDistance"/> is no longer than a distance, metres; 0 where there is none left.
        /// </summary>
        public float SpeedToStopWithin(float distance)
        {
            float answer = k_Response * Acceleration;
            return distance > 0f ? math.sqrt(answer * answer + 2f * Acceleration * distance) - answer : 0f;
        }

        /// <summary>
        /// Fastest turn of the course at a speed, rad/s: a/v, and no faster than at the top speed, as a slow monarch that does loses its
        /// speed; 1.9 for a monarch.
        /// </summary>
        public float TurnRate(float speed) => Acceleration / math.max(math.abs(speed), TopSpeed);

        /// <summary>Metres of the tightest turn at a speed: v over <see cref="TurnRate"/>; 0.7 m at 1.3 m/s for a monarch.</summary>
        public float TurnRadius(float speed) => math.abs(speed) / TurnRate(speed);
    }
}
