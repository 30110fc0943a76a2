namespace Alate
{
    /// <summary>
    /// Layout of one point of a trim table, floats: attitude and beat that carry the insect at one speed and climb, the bob of its body in
    /// that beat, the gains of the feedback, and the air that the wake sets moving at the wings. Longitudinal and lateral motion are apart,
    /// as they are for a body with a plane of symmetry.
    /// </summary>
    internal static class TrimPoint
    {
        /// <summary>Harmonics of the bob.</summary>
        public const int Harmonics = 6;

        /// <summary>Coordinates that bob: velocity up and ahead (m/s), turn and rate about X (radians, rad/s).</summary>
        public const int Bobbing = 4;

        /// <summary>Longitudinal commands: frequency, amplitude, tilt, mean sweep.</summary>
        public const int LongCommands = 4;

        /// <summary>Longitudinal states: velocity up and ahead, turn and rate about X, integrals up and ahead, the last commands.</summary>
        public const int LongStates = 10;

        /// <summary>Lateral commands: difference of amplitude and of feather, right less left.</summary>
        public const int SideCommands = 2;

        /// <summary>
        /// Lateral states: velocity to the right, turns about Y and Z, rates about Y and Z, integral to the right, the last commands.
        /// </summary>
        public const int SideStates = 8;

        /// <summary>Offsets: pitch (radians, nose up); frequency (Hz), amplitude (factor), tilt and mean sweep (radians).</summary>
        public const int Pitch = 0, Drive = 1;

        /// <summary>Offset of the bob: [coordinate][harmonic] cosine, sine.</summary>
        public const int Bob = Drive + LongCommands;

        /// <summary>Offsets of the gains, [command][state], commands in units of <see cref="FlightCommands"/>.</summary>
        public const int LongGains = Bob + 2 * Harmonics * Bobbing, SideGains = LongGains + LongCommands * LongStates;

        /// <summary>Most pairs of wings whose wake a table holds, and floats of the air of one.</summary>
        public const int Pairs = 2, InflowFloats = 15;

        /// <summary>
        /// Offset of the air that the wake sets moving at each pair of wings, [pair] <see cref="WingInflow"/>, wing lengths per second.
        /// </summary>
        public const int Inflow = SideGains + SideCommands * SideStates;

        /// <summary>Floats of a point.</summary>
        public const int Floats = Inflow + Pairs * InflowFloats;
    }
}
