using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Watches a flight, step by step, for tumbles.</summary>
    internal struct TumbleWatch
    {
        private float3 m_Way;
        private FlightTumble m_Last;

        /// <summary>True while the insect tumbles.</summary>
        public bool IsTumbling { get; private set; }

        /// <summary>Number of tumbles so far, with the one that lasts.</summary>
        public int Count { get; private set; }

        /// <summary>Tumble that lasts, or the last one.</summary>
        public readonly FlightTumble Last => m_Last;

        /// <summary>Takes in a step.</summary>
        /// <param name="tumbles">True where the insect tumbles at its end.</param>
        /// <param name="moved">Way within it, metres.</param>
        /// <param name="time">Its end, seconds that the insect has flown.</param>
        /// <param name="dt">Its length, seconds.</param>
        /// <returns>True where a tumble begins or has ended.</returns>
        public bool Step(bool tumbles, float3 moved, double time, float dt)
        {
            bool changes = tumbles != IsTumbling;
            if (IsTumbling)
            {
                m_Way += moved;
                m_Last.seconds += dt;
                m_Last.distance = math.length(m_Way);
            }
            else if (tumbles)
            {
                m_Way = default;
                m_Last = new FlightTumble { time = time };
                Count++;
            }

            IsTumbling = tumbles;
            return changes;
        }
    }
}
