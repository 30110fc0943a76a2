namespace Alate.Flight
{
    /// <summary>Decides where an insect flies. Asked on the main thread once a step of the wings; allocates nothing there.</summary>
    public interface IFlightPilot
    {
        /// <summary>
        /// Wanted velocity and heading for the next step. In a scene a velocity that is not finite is refused, and the last good one
        /// counts; a heading that is no number leaves it to the flight.
        /// </summary>
        FlightCommand Command(in FlightSituation situation);
    }
}
