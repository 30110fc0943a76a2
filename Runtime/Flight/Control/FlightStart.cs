namespace Alate.Flight
{
    /// <summary>
    /// Start of a flight: in the trim of a condition with settled wings, or on the spot with wings that begin their beat, as in a scene.
    /// </summary>
    internal struct FlightStart
    {
        /// <summary>True where the wings have settled on the trim's beat.</summary>
        public bool settled;

        /// <summary>Speed and climb to start with; level on the spot where the wings begin.</summary>
        public FlightCondition condition;

        /// <summary>Heading, radians.</summary>
        public float heading;

        /// <summary>Degrees of the beat at which wings that are not settled begin.</summary>
        public float phase;
    }
}
