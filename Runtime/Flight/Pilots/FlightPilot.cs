using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Flight
{
    /// <summary>
    /// Pilot that is a component. The Insect Flight takes the first one on its own object; a pilot that lets another fly now and then, or
    /// asks it for the way, takes the next one below itself.
    /// </summary>
    public abstract class FlightPilot : MonoBehaviour, IFlightPilot
    {
        /// <summary>Bounds of the speed that a pilot is set to, m/s.</summary>
        internal const float LeastSpeed = 0.05f, MostSpeed = 5f;

        private static readonly List<FlightPilot> s_Found = new List<FlightPilot>();

        private FlightPilot m_Below;
        private readonly ObstacleSense m_Sense = new ObstacleSense();
        private string m_LastWarning;

        /// <summary>True where colliders leave no way on.</summary>
        protected bool IsBlocked => m_Sense.IsBlocked;

        /// <inheritdoc/>
        public abstract FlightCommand Command(in FlightSituation situation);

        /// <summary>Finds where what the insect sits on is by now; false where the pilot knows of nothing that may move.</summary>
        internal virtual bool TryFindPerch(out PerchSpot spot)
        {
            spot = default;
            return false;
        }

        /// <summary>Changes a velocity so that the insect flies round colliders, whose rays all insects cast in one batch.</summary>
        /// <param name="velocity">Wanted, m/s along the world's axes.</param>
        /// <param name="situation">The insect now.</param>
        /// <param name="obstacles">What is avoided.</param>
        /// <param name="goal">Metres to the goal; what is behind it is not in the way.</param>
        protected float3 Avoid(
            float3 velocity, in FlightSituation situation, in ObstacleSettings obstacles, float goal = float.PositiveInfinity)
        {
            ObstacleRays.Update();
            return m_Sense.Avoid(velocity, situation, obstacles, goal);
        }

        /// <summary>The next pilot below this one on the object that is on; null for none.</summary>
        protected FlightPilot Below()
        {
            if (m_Below != null && m_Below.isActiveAndEnabled)
                return m_Below;
            m_Below = null;
            GetComponents(s_Found);
            for (int k = s_Found.IndexOf(this) + 1; k < s_Found.Count && m_Below == null; k++)
                m_Below = s_Found[k].isActiveAndEnabled ? s_Found[k] : null;
            s_Found.Clear();
            return m_Below;
        }

        /// <summary>Logs a warning, each new one once.</summary>
        private protected void Warn(string message)
        {
            if (message == m_LastWarning)
                return;
            m_LastWarning = message;
            Debug.LogWarning(message, this);
        }
    }
}
