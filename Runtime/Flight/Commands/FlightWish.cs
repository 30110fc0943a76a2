namespace Alate.Flight
{
    /// <summary>Wish of a pilot besides a velocity.</summary>
    public enum FlightWish
    {
        /// <summary>Flies on; a perched insect takes off.</summary>
        Fly,

        /// <summary>
        /// Comes down on <see cref="FlightCommand.spot"/>: the state becomes <see cref="FlightState.Landing"/>, the pilot still says the
        /// velocity.
        /// </summary>
        Land,

        /// <summary>
        /// Sits on <see cref="FlightCommand.spot"/> from now on: the body glides there, not flown by its wings, and then the state becomes
        /// <see cref="FlightState.Perched"/>.
        /// </summary>
        Perch,
    }
}
