using UnityEngine;

namespace Alate.Flight
{
    /// <summary>Pilot that is a component: found by the Insect Flight on its own object.</summary>
    public abstract class FlightPilot : MonoBehaviour, IFlightPilot
    {
        /// <inheritdoc/>
        public abstract FlightCommand Command(in FlightSituation situation);
    }
}
