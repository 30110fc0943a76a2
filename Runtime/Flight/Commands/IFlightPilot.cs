namespace Alate.Flight
{
    /// <summary>Decides where an insect flies. Asked on the main thread once a step of the wings; allocates nothing there.</summary>
    public interface IFlightPilot
    {
        /// <summary>Wanted velocity and heading for the next step. Values that are not finite count as hovering on the spot.</summary>
        FlightCommand Command(in FlightSituation situation);
    }
}
