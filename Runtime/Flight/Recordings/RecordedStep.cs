using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>One step of a recorded flight: what the insect met in it, and what its pilot asked for.</summary>
    internal struct RecordedStep
    {
        /// <summary>Seconds of a step of the wings.</summary>
        public float length;

        /// <summary>Number of steps of the wings for which the command holds.</summary>
        public int count;

        /// <summary>Wanted velocity over ground, m/s along the world's axes.</summary>
        public float3 velocity;

        /// <summary>Wanted heading, radians; not a number follows the way.</summary>
        public float heading;

        /// <summary>Velocity of the air, m/s.</summary>
        public float3 wind;

        /// <summary>Gravity, m/s².</summary>
        public float3 gravity;

        /// <summary>Outer help, 0 to 1.</summary>
        public float aid;

        /// <summary>True where commands were not kept within what the insect flies.</summary>
        public bool isUnguarded;

        /// <param name="command">Command; a velocity that is not finite counts as none, as in flight.</param>
        /// <param name="length">Seconds of a step of the wings.</param>
        /// <param name="count">Number of steps of the wings.</param>
        public RecordedStep(in FlightCommand command, float length, int count)
            : this()
        {
            this.length = length;
            this.count = count;
            velocity = math.all(math.isfinite(command.velocity)) ? command.velocity : default;
            heading = math.isfinite(command.heading) ? command.heading : float.NaN;
        }
    }
}
