using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>The wind of Unity's wind zones at a place and time, in world units per second.</summary>
    /// <remarks>
    /// Unity says what a zone's numbers are for, not how trees use them. Here: main wind times one plus the pulse (a sine of its magnitude
    /// and frequency) plus turbulence (smooth noise up to a third of the main wind at turbulence 1), along the zone's forward axis, or
    /// outwards and fading towards the radius.
    /// </remarks>
    internal sealed class WindZones
    {
        private const float k_TurbulenceShare = 1f / 3f, k_TurbulenceRate = 3f, k_TurbulencePerUnit = 0.2f;

        /// <summary>Time between searches for zones, seconds.</summary>
        private const double k_Pause = 1.0;

        /// <summary>Largest number of a zone, in its own units: one beyond it is refused.</summary>
        private const float k_Most = 1e6f;

        /// <summary>Zones whose last numbers are kept before those that are gone are forgotten with all others.</summary>
        private const int k_MostKnown = 256;

        private readonly List<WindZone> m_Zones = new List<WindZone>();
        private readonly Dictionary<WindZone, Known> m_Known = new Dictionary<WindZone, Known>();
        private readonly List<Zone> m_Blowing = new List<Zone>();
        private bool m_IsKnown, m_MayHaveChanged;
        private double m_Found;

        /// <summary>Forgets the zones; they are searched at the next reading.</summary>
        public void Forget() => m_IsKnown = false;

        /// <summary>Marks the zones as possibly changed, because an object has come: they are searched soon, however many come.</summary>
        public void Invalidate() => m_MayHaveChanged = true;

        /// <summary>Reads all zones; those that are gone or switched off do not blow.</summary>
        /// <param name="time">Seconds.</param>
        public void Read(float time)
        {
            if (!m_IsKnown || (m_MayHaveChanged && Time.realtimeSinceStartupAsDouble - m_Found >= k_Pause))
                Find();
            m_Blowing.Clear();
            foreach (WindZone zone in m_Zones)
            {
                if (zone != null && zone.gameObject.activeInHierarchy && Numbers(zone, out float4 numbers))
                    m_Blowing.Add(new Zone(zone, numbers, time));
            }
        }

        // Main wind, magnitude and frequency of the pulse, turbulence; the last good ones where they are not possible.
        private bool Numbers(WindZone zone, out float4 numbers)
        {
            Known known = m_Known[zone];
            var read = new float4(zone.windMain, zone.windPulseMagnitude, zone.windPulseFrequency, zone.windTurbulence);
            if (math.all(math.abs(read) <= k_Most) && math.isfinite(zone.radius))
            {
                known.numbers = read;
                known.isGood = true;
            }
            else if (!known.isTold)
            {
                known.isTold = true;
                string what = $"main wind {read.x}, pulse {read.y} at {read.z} Hz, turbulence {read.w}, radius {zone.radius}";
                Debug.LogWarning(
                    $"'{zone.name}': a wind zone of {what} is refused, the last good one counts: all must be at most {k_Most}.", zone);
            }

            numbers = known.numbers;
            return known.isGood;
        }

        /// <summary>Wind at a place, as last read, world units per second.</summary>
        public float3 At(float3 place)
        {
            float3 sum = default;
            foreach (Zone zone in m_Blowing)
                sum += zone.At(place);
            return sum;
        }

        // Those of assets are in no scene.
        private void Find()
        {
            m_IsKnown = true;
            m_MayHaveChanged = false;
            m_Found = Time.realtimeSinceStartupAsDouble;
            m_Zones.Clear();
            if (m_Known.Count > k_MostKnown)
                m_Known.Clear();
            foreach (WindZone zone in Resources.FindObjectsOfTypeAll<WindZone>())
            {
                if (!zone.gameObject.scene.IsValid())
                    continue;
                m_Zones.Add(zone);
                if (!m_Known.ContainsKey(zone))
                    m_Known.Add(zone, new Known());
            }
        }

        /// <summary>Last good numbers of a zone.</summary>
        private sealed class Known
        {
            public float4 numbers;
            public bool isGood, isTold;
        }

        private readonly struct Zone
        {
            private readonly float3 m_Position, m_Direction;
            private readonly float m_Main, m_Steady, m_Turbulence, m_GustTime;

            // 0 for one that blows everywhere in one direction.
            private readonly float m_Radius;

            public Zone(WindZone zone, float4 numbers, float time)
            {
                Transform transform = zone.transform;
                m_Position = transform.position;
                m_Direction = transform.forward;
                m_Radius = zone.mode == WindZoneMode.Spherical ? math.max(zone.radius, 1e-6f) : 0f;
                m_Main = numbers.x;
                m_Steady = 1f + numbers.y * Elementary.Sin(2f * math.PI * numbers.z * time);
                m_Turbulence = k_TurbulenceShare * numbers.w;
                m_GustTime = k_TurbulenceRate * time;
            }

            public float3 At(float3 place)
            {
                float3 outwards = place - m_Position;
                bool everywhere = m_Radius == 0f;
                float3 direction = everywhere ? m_Direction : math.normalizesafe(outwards);
                float share = everywhere ? 1f : math.saturate(1f - math.length(outwards) / m_Radius);
                float gust = m_Turbulence * Gust(math.dot(place, k_TurbulencePerUnit) + m_GustTime);
                return direction * (share * m_Main * (m_Steady + gust));
            }
        }

        // Smooth noise in [-1, 1] from two sines whose rates have no common period.
        private static float Gust(float t) => 0.5f * (Elementary.Sin(t) + Elementary.Sin(2.414f * t + 1.3f));
    }
}
