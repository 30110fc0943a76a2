using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Flight
{
    /// <summary>
    /// Finds who steers an insect: the pilot that a script has set, else the first Flight Pilot of the object. Those that are off are not
    /// asked, nor is one that has thrown.
    /// </summary>
    internal sealed class PilotSeat
    {
        /// <summary>Seconds after which the object is searched for a pilot that came or was switched on.</summary>
        private const double k_Search = 0.25;

        private static readonly List<FlightPilot> s_Found = new List<FlightPilot>();

        private readonly Component m_Insect;
        private IFlightPilot m_Given, m_Faulted;
        private FlightPilot m_Found;
        private double m_NextSearch = double.NegativeInfinity;

        /// <param name="insect">A component of the object on which pilots stand.</param>
        public PilotSeat(Component insect) => m_Insect = insect;

        /// <summary>True where the pilot has thrown and is asked no more.</summary>
        public bool HasFailed => m_Faulted != null;

        /// <summary>Pilot that steers: set by a script, or else found; null for none.</summary>
        public IFlightPilot Pilot
        {
            get => IsOn(m_Given) ? m_Given : IsOn(m_Found) ? m_Found : null;
            set
            {
                m_Given = value;
                Restart();
            }
        }

        /// <summary>Searches at once, and asks a pilot again that has thrown.</summary>
        public void Restart()
        {
            m_Faulted = null;
            m_NextSearch = double.NegativeInfinity;
        }

        /// <summary>Command for the coming step.</summary>
        /// <param name="situation">The insect now.</param>
        /// <param name="without">Command where there is no pilot.</param>
        public FlightCommand Command(in FlightSituation situation, in FlightCommand without)
        {
            if (m_Faulted != null && !IsOn(m_Faulted))
                Restart();
            if (situation.time >= m_NextSearch || !(m_Found is null) && !IsOn(m_Found))
                Search(situation.time);
            IFlightPilot pilot = Pilot;
            if (pilot == null)
                return without;
            if (ReferenceEquals(pilot, m_Faulted))
                return FlightCommand.Fly(default);
            try
            {
                return pilot.Command(situation);
            }
            catch (Exception exception)
            {
                m_Faulted = pilot;
                Debug.LogException(new InvalidOperationException($"The pilot {pilot.GetType().Name} of "
                    + $"'{m_Insect.name}' threw an exception, and is asked no more until it is switched off and on, or another pilot is "
                    + "set. The insect hovers.", exception), m_Insect);
                return FlightCommand.Fly(default);
            }
        }

        /// <summary>Finds where what the insect sits on is by now; false where the pilot does not know of anything that moves.</summary>
        public bool TryFindPerch(out PerchSpot spot)
        {
            spot = default;
            return Pilot is FlightPilot pilot && pilot.TryFindPerch(out spot);
        }

        private void Search(double time)
        {
            m_NextSearch = time + k_Search;
            m_Found = null;
            m_Insect.GetComponents(s_Found);
            for (int k = 0; k < s_Found.Count && m_Found is null; k++)
                m_Found = s_Found[k].isActiveAndEnabled ? s_Found[k] : null;
            s_Found.Clear();
        }

        private static bool IsOn(IFlightPilot pilot)
        {
            switch (pilot)
            {
                case Behaviour behaviour: return behaviour != null && behaviour.isActiveAndEnabled;
                case Object asset: return asset != null;
                default: return pilot != null;
            }
        }
    }
}
