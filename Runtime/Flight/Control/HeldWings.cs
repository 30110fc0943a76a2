using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Wings of an insect that a perch holds: they rest, beat raised above the body, or beat as in a hover.</summary>
    internal readonly struct HeldWings
    {
        /// <summary>Share of the amplitude of hovering that is left to raised wings: the upper part of their stroke, above level.</summary>
        private const float k_RaisedShare = 0.45f;

        private readonly WingWorld m_World;
        private readonly BodyHandle m_Body;
        private readonly LiveInsect m_Live;
        private readonly FlightModel m_Model;
        private readonly TrimTable m_Table;

        /// <param name="world">Where the wings are.</param>
        /// <param name="body">The body that they carry.</param>
        /// <param name="live">The insect.</param>
        /// <param name="model">Its model, with the same wings in the same order.</param>
        /// <param name="table">Its trims.</param>
        public HeldWings(WingWorld world, BodyHandle body, LiveInsect live, FlightModel model, TrimTable table)
        {
            m_World = world;
            m_Body = body;
            m_Live = live;
            m_Model = model;
            m_Table = table;
        }

        /// <summary>Frequency of the beat of hovering, hertz.</summary>
        public float Frequency => Hover.frequency;

        /// <summary>Share of the beat that is over.</summary>
        public float Phase => m_World.Read(m_Live.wings[0].handle).Phase / (2f * math.PI);

        /// <summary>Beats completed.</summary>
        public int Beats => m_World.Read(m_Live.wings[0].handle).Beats;

        private WingDrive Hover => m_Table.DriveNear(0f, 0f);

        /// <summary>Turns the body as it hovers at the phase that the beat has in so many seconds.</summary>
        public void PlaceOnBob(float later) => m_World.PlaceOnBob(m_Body, later);

        /// <summary>Lets the wings come to rest.</summary>
        public void Rest()
        {
            foreach (LiveWing wing in m_Live.wings)
                m_World.SetDrive(wing.handle, new WingDrive { frequency = m_Model.Frequency, amplitude = 0f });
        }

        /// <summary>Beats as in a hover.</summary>
        public void BeatWhole()
        {
            WingDrive hover = Hover;
            foreach (LiveWing wing in m_Live.wings)
                m_World.SetDrive(wing.handle, hover);
        }

        /// <summary>Beats from above level up to where wings turn in a hover, straight up and down: none gets below the body.</summary>
        public void BeatRaised()
        {
            WingDrive hover = Hover;
            for (int k = 0; k < m_Live.wings.Length; k++)
            {
                WingParameters parameters = m_Model.Wings[k].Parameters;
                float flap = hover.amplitude * parameters.amplitude.x * parameters.amplitudeScale;
                m_World.SetDrive(m_Live.wings[k].handle, new WingDrive
                {
                    frequency = hover.frequency,
                    amplitude = k_RaisedShare * hover.amplitude,
                    meanFlap = math.min((1f - k_RaisedShare) * flap, math.PI),
                });
            }
        }
    }
}
