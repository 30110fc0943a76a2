using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Raises the events of beats. A listener may destroy or make insects; an exception in one is logged and keeps neither the event of the
    /// inspector nor other insects' from being raised.
    /// </summary>
    internal sealed class BeatCalls
    {
        private readonly List<InsectWings> m_Beating = new List<InsectWings>();

        /// <summary>
        /// Raises the event of every insect whose first wing has begun a new cycle since the last call; once, however many cycles it began.
        /// </summary>
        public void RaiseBeatEvents(List<LiveInsect> insects, WingWorld world)
        {
            foreach (LiveInsect live in insects)
            {
                int beats = world.Read(live.wings[0].handle).Beats;
                if (beats > live.beats)
                    m_Beating.Add(live.insect);
                live.beats = beats;
            }

            if (m_Beating.Count == 0)
                return;
            using (SystemMarkers.events.Auto())
            {
                foreach (InsectWings insect in m_Beating)
                {
                    if (insect != null && insect.Live != null)
                        RaiseBeatEvents(insect);
                }
            }

            m_Beating.Clear();
        }

        private static void RaiseBeatEvents(InsectWings insect)
        {
            try
            {
                insect.TellBeat();
            }
            catch (Exception exception)
            {
                Debug.LogException(exception, insect);
            }
        }
    }
}
