using Alate.Flight;
using Unity.Mathematics;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Flower that sways once a second, as the wind's gusts take it.</summary>
    [RequireComponent(typeof(PerchMark))]
    internal sealed class SwayingMark : MonoBehaviour
    {
        private PerchSpot m_Spot;
        private float3 m_Way;
        private float m_Phase;

        /// <summary>Puts it to a spot, from where it moves to both sides of it.</summary>
        /// <param name="spot">Where it is on average.</param>
        /// <param name="way">From there to its farthest, world units.</param>
        /// <param name="phase">Where it begins, share of a sway.</param>
        public void Place(in PerchSpot spot, float3 way, float phase)
        {
            m_Spot = spot;
            m_Way = way;
            m_Phase = phase - Time.time;
            Update();
        }

        private void Update()
        {
            var ahead = new float3(math.sin(m_Spot.heading), 0f, math.cos(m_Spot.heading));
            float sway = math.sin(2f * math.PI * (Time.time + m_Phase));

            // As it goes it leans.
            float3 up = math.normalize(m_Spot.normal + 0.05f * sway * math.normalize(m_Way));
            ahead = math.normalize(ahead - up * math.dot(ahead, up));
            transform.SetPositionAndRotation(m_Spot.position + sway * m_Way, quaternion.LookRotation(ahead, up));
        }
    }
}
