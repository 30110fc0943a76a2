namespace Alate.Flight
{
    /// <summary>A steady flight: speed ahead through the air and climb.</summary>
    public readonly struct FlightCondition
    {
        /// <param name="speed">Ahead, m/s.</param>
        /// <param name="climb">Up, m/s.</param>
        public FlightCondition(float speed, float climb)
        {
            Speed = speed;
            Climb = climb;
        }

        /// <summary>Ahead through the air, m/s.</summary>
        public float Speed { get; }

        /// <summary>Up, m/s.</summary>
        public float Climb { get; }

        /// <inheritdoc/>
        public override string ToString() => System.FormattableString.Invariant($"{Speed} m/s ahead, {Climb} m/s up");
    }
}
