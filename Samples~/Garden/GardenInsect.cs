using Alate.Catalogue;
using Alate.Flight;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Samples
{
    /// <summary>
    /// One insect of the garden that flies by its own wings: its pilots stand on it one below the other, the first one decides.
    /// </summary>
    internal sealed class GardenInsect
    {
        private readonly InsectWings m_Wings;
        private readonly InsectFlight m_Flight;
        private Light m_Lantern;
        private MeshRenderer m_Glow;
        private PerchPilot m_Perch;
        private readonly float m_Delay;

        private GardenInsect(InsectDefinition species, Transform parent, Vector3 place, int number)
        {
            m_Wings = InsectFactory.Create(species, InsectVariant.Flight);
            m_Wings.transform.SetParent(parent, false);
            m_Wings.transform.localPosition = place;
            m_Wings.transform.localRotation = Quaternion.Euler(0f, 137.5f * number, 0f);
            m_Wings.StartPhase = 137.5f * number % 360f;
            m_Delay = 0.37f * number;
            m_Flight = CatalogueFlight.AddTo(m_Wings, species);
        }

        /// <summary>Help from outside in gusts, 0 to 1.</summary>
        public float Aid
        {
            set => m_Flight.Aid = value;
        }

        /// <summary>Velocity of the air, world units per second.</summary>
        public Vector3 Wind
        {
            set => m_Wings.Air.wind = value;
        }

        /// <summary>Distance of the camera at which the insect takes off, world units; 0 for none.</summary>
        public float Shy
        {
            set
            {
                if (m_Perch != null)
                    m_Perch.Settings.fleeDistance = value;
            }
        }

        /// <summary>Middle of its thorax, world units.</summary>
        public Vector3 Position => m_Flight.Position;

        /// <summary>True where the insect sits.</summary>
        public bool Sits => m_Flight.State == FlightState.Perched;

        /// <summary>A butterfly that wanders, lands on flowers, basks, and flees from a camera.</summary>
        public static GardenInsect Butterfly(InsectDefinition species, Transform parent, FlightVolume volume, Transform eye, int number)
        {
            var made = new GardenInsect(species, parent, Within(volume, number), number);
            PerchPilot perch = made.m_Perch = made.m_Wings.gameObject.AddComponent<PerchPilot>();
            perch.Seed = number;
            perch.Settings.flightTime = 8f;
            perch.Watched.Add(eye);
            made.Wander(volume, number);
            return made;
        }

        /// <summary>A firefly, which only wanders.</summary>
        /// <param name="parent">Of the insect.</param>
        /// <param name="volume">Where it flies.</param>
        /// <param name="number">Chooses its place and its way.</param>
        /// <param name="glow">Mesh of its flash.</param>
        /// <param name="clear">Material of that.</param>
        public static GardenInsect Firefly(Transform parent, FlightVolume volume, int number, Mesh glow, Material clear)
        {
            var made = new GardenInsect(InsectCatalogue.Find("firefly"), parent, Within(volume, number), number);
            made.AddLantern(glow, clear);
            WanderPilot wander = made.Wander(volume, number);
            wander.Settings.speed = 0.5f;
            wander.Settings.bob = 0.1f;
            return made;
        }

        /// <summary>Lights the lantern: a flash of half a second every 5.5 seconds, as Photinus pyralis does.</summary>
        /// <param name="time">Seconds.</param>
        /// <param name="dusk">0 by day to 1 at night.</param>
        public void Glow(float time, float dusk)
        {
            if (m_Lantern == null)
                return;
            float since = Mathf.Repeat(time + m_Delay, 5.5f);
            m_Lantern.intensity = since < 0.5f ? 2f * dusk * Mathf.Sin(Mathf.PI * since / 0.5f) : 0f;
            m_Glow.enabled = m_Lantern.intensity > 0f;
        }

        /// <summary>Ends the insect.</summary>
        public void Destroy() => Object.Destroy(m_Wings.gameObject);

        private WanderPilot Wander(FlightVolume volume, int number)
        {
            WanderPilot wander = m_Wings.gameObject.AddComponent<WanderPilot>();
            wander.Seed = number;
            wander.Volume = volume;
            return wander;
        }

        private void AddLantern(Mesh glow, Material clear)
        {
            var lantern = new GameObject("Lantern");
            lantern.transform.SetParent(m_Wings.transform, false);
            lantern.transform.localPosition = new Vector3(0f, -0.03f, -0.07f);
            m_Lantern = lantern.AddComponent<Light>();
            m_Lantern.color = new Color(0.85f, 1f, 0.35f);
            m_Lantern.range = 2f;
            m_Lantern.intensity = 0f;
            lantern.AddComponent<MeshFilter>().sharedMesh = glow;
            m_Glow = lantern.AddComponent<MeshRenderer>();
            m_Glow.sharedMaterial = clear;
            m_Glow.shadowCastingMode = ShadowCastingMode.Off;
            m_Glow.enabled = false;
        }

        // Spread evenly by the golden ratio's relatives.
        private static Vector3 Within(FlightVolume volume, int number)
        {
            Vector3 share = new Vector3(0.755f * number % 1f, 0.57f * number % 1f, 0.43f * number % 1f) - 0.5f * Vector3.one;
            return volume.centre + 0.6f * Vector3.Scale(share, volume.size);
        }
    }
}
