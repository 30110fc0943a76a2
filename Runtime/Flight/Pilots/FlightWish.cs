namespace Alate.Flight
{
    /// <summary>What a pilot wants besides a velocity.</summary>
    public enum FlightWish
    {
        /// <summary>To fly on; a perched insect takes off.</summary>
        Fly,

        /// <summary>To come down on <see cref="FlightCommand.spot"/>: the state becomes <see cref="FlightState.Landing"/>, the pilot still says the velocity.</summary>
        Land,

        /// <summary>To sit on <see cref="FlightCommand.spot"/> from now on: the body glides there, not flown by its wings, and then the state becomes <see cref="FlightState.Perched"/>.</summary>
        Perch,
    }
}
