using System.Collections.Generic;

namespace Alate
{
    /// <summary>Tells insects that a beat began. Whoever listens may destroy or make insects.</summary>
    internal sealed class BeatCalls
    {
        private readonly List<InsectWings> m_Beating = new List<InsectWings>();

        /// <summary>Tells all whose first wing has begun a new cycle since the last call; once, however many it began.</summary>
        public void Tell(List<LiveInsect> insects, WingWorld world)
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
                        insect.TellBeat();
                }
            }

            m_Beating.Clear();
        }
    }
}
