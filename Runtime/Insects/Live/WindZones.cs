using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Alate
{
    /// <summary>The wind of Unity's wind zones at a place and time, in world units per second.</summary>
    /// <remarks>
    /// Unity says what a zone's numbers are for, not how trees use them. Here: main wind times one plus the pulse (a sine of its magnitude and frequency) plus turbulence
    /// (smooth noise up to a third of the main wind at turbulence 1), along the zone's forward axis, or outwards and fading towards the radius.
    /// </remarks>
    internal sealed class WindZones
    {
        private const float k_TurbulenceShare = 1f / 3f, k_TurbulenceRate = 3f, k_TurbulencePerUnit = 0.2f;

        private readonly List<WindZone> m_Zones = new List<WindZone>();
        private readonly List<WindZone> m_Found = new List<WindZone>();
        private readonly List<GameObject> m_Roots = new List<GameObject>();

        /// <summary>Looks for the zones of all loaded scenes.</summary>
        public void Find()
        {
            m_Zones.Clear();
            for (int s = 0; s < SceneManager.sceneCount; s++)
            {
                Scene scene = SceneManager.GetSceneAt(s);
                if (!scene.isLoaded)
                    continue;
                scene.GetRootGameObjects(m_Roots);
                foreach (GameObject root in m_Roots)
                {
                    root.GetComponentsInChildren(true, m_Found);
                    m_Zones.AddRange(m_Found);
                }
            }
        }

        /// <summary>The wind at a place; zones that are gone or switched off do not blow.</summary>
        public float3 At(float3 place, float time)
        {
            float3 sum = default;
            foreach (WindZone zone in m_Zones)
            {
                if (zone != null && zone.gameObject.activeInHierarchy)
                    sum += Blow(zone, place, time);
            }

            return sum;
        }

        private static float3 Blow(WindZone zone, float3 place, float time)
        {
            Transform transform = zone.transform;
            float3 direction = transform.forward;
            float share = 1f;
            if (zone.mode == WindZoneMode.Spherical)
            {
                float3 outwards = place - (float3)transform.position;
                float distance = math.length(outwards);
                share = math.saturate(1f - distance / math.max(zone.radius, 1e-6f));
                direction = math.normalizesafe(outwards);
            }

            float pulse = zone.windPulseMagnitude * math.sin(2f * math.PI * zone.windPulseFrequency * time);
            float turbulence = k_TurbulenceShare * zone.windTurbulence * Gust(math.dot(place, k_TurbulencePerUnit) + k_TurbulenceRate * time);
            return direction * (share * zone.windMain * (1f + pulse + turbulence));
        }

        // Smooth noise in [-1, 1] from two sines whose rates have no common period.
        private static float Gust(float t) => 0.5f * (math.sin(t) + math.sin(2.414f * t + 1.3f));
    }
}
