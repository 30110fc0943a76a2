using Unity.Mathematics;

namespace Alate.Flight
{
    /// <summary>Box within which a spot has moved of late: over the last one to two spans of time.</summary>
    internal struct PerchSway
    {
        /// <summary>Seconds of a span: what sways once in a second is known whole.</summary>
        private const float k_Span = 1.5f;

        private float3 m_Least, m_Most, m_LeastBefore, m_MostBefore;
        private float m_Time;

        /// <param name="position">Where the spot is at first, world units.</param>
        public PerchSway(float3 position)
        {
            m_Least = m_Most = m_LeastBefore = m_MostBefore = position;
            m_Time = 0f;
        }

        /// <summary>Middle of the box; of a spot that stays, the spot.</summary>
        public readonly float3 Middle =>
            0.5f * (math.min(m_Least, m_LeastBefore) + math.max(m_Most, m_MostBefore));

        /// <summary>Half the extent of the box along a unit vector, world units.</summary>
        public readonly float Along(float3 direction) =>
            0.5f * math.dot(math.abs(direction), math.max(m_Most, m_MostBefore) - math.min(m_Least, m_LeastBefore));

        /// <summary>Takes in where the spot is by now.</summary>
        public void Add(float3 position, float deltaTime)
        {
            m_Time += deltaTime;
            if (m_Time >= k_Span)
            {
                m_Time = 0f;
                m_LeastBefore = m_Least;
                m_MostBefore = m_Most;
                m_Least = m_Most = position;
            }

            m_Least = math.min(m_Least, position);
            m_Most = math.max(m_Most, position);
        }
    }
}
