using Unity.Mathematics;

namespace Alate
{
    /// <summary>
    /// The six commands of a beat, in the order of the gains: what a unit of each is, and how far each may leave the trim.
    /// </summary>
    internal static class FlightCommands
    {
        public const int Count = TrimPoint.LongCommands + TrimPoint.SideCommands;

        private const float k_Degree = math.PI / 180f;

        /// <summary>Share of the beat's own frequency that counts as a unit; the gains weigh a unit of each command alike.</summary>
        private const float k_Frequency = 0.08f;

        /// <summary>Units of amplitude, tilt, mean sweep, difference of amplitude and difference of feather.</summary>
        private const float k_Amplitude = 0.10f, k_Tilt = 8f * k_Degree, k_Sweep = 8f * k_Degree, k_Side = 0.10f, k_Feather = 6f * k_Degree;

        /// <summary>A unit of a command.</summary>
        /// <param name="command">Index.</param>
        /// <param name="frequency">F0, hertz.</param>
        public static float Unit(int command, float frequency) =>
            command == 0 ? k_Frequency * frequency
            : command == 1 ? k_Amplitude : command == 2 ? k_Tilt : command == 3 ? k_Sweep : command == 4 ? k_Side : k_Feather;

        /// <summary>
        /// Largest departure from the trim, in units: 15 % of the frequency, 0.2 of the amplitude, 20° of tilt and sweep, 0.2 and 15°
        /// between the sides.
        /// </summary>
        public static float Limit(int command) =>
            command == 0 ? 0.15f / k_Frequency : command == 1 || command == 4 ? 2f : 2.5f;
    }
}
