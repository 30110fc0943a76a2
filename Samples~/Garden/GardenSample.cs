using System.Collections.Generic;
using Alate.Catalogue;
using Alate.Flight;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// A garden: monarchs and swallowtails fly by their own wings, land on flowers, bask, and flee from the camera; fireflies blink at
    /// dusk; a snailfish swims in the pond around.
    /// </summary>
    [AddComponentMenu("Alate/Samples/Garden Sample")]
    [DisallowMultipleComponent]
    public sealed class GardenSample : MonoBehaviour
    {
        private const int k_Most = 60, k_Flowers = 16, k_Fireflies = 3;
        private const float k_CameraDistance = 18f, k_GardenRadius = 16f, k_PondRadius = 52f, k_PondDepth = 8f, k_WaterDepth = 0.3f;
        private const float k_NearDistance = 5f, k_FollowRate = 3f, k_MostShy = 12f;

        private static readonly Color[] s_Petals =
        {
            new Color(0.9f, 0.4f, 0.6f), new Color(0.95f, 0.85f, 0.3f), new Color(0.75f, 0.6f, 0.95f), new Color(0.95f, 0.95f, 0.9f),
        };

        [SerializeField, Range(0, k_Most)]
        [Tooltip("Butterflies, 0 to 60; 8.")]
        private int m_Count = 8;

        [SerializeField, Range(0f, 2f)]
        [Tooltip("Metres per second of wind along X, 0 to 2; 0. Flowers lean and sway in it.")]
        private float m_Wind;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("Help from outside after a tumble, 0 to 1; 0.3. 0 flies by the wings alone.")]
        private float m_Aid = 0.3f;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("0 by day, 1 at night: fireflies blink.")]
        private float m_Dusk = 0.2f;

        [SerializeField, Range(0f, k_MostShy)]
        [Tooltip("World units from the camera at which butterflies take off, 0 to 12; 6. 0 lets it come as near as it likes.")]
        private float m_Shy = 6f;

        [SerializeField, Range(0, k_Most)]
        [Tooltip("Number of the butterfly that the camera follows, 0 to 60; 0 follows none.")]
        private int m_Watched;

        private readonly ScreenPanel m_Panel = new ScreenPanel(280f);
        private readonly List<GardenInsect> m_Butterflies = new List<GardenInsect>(), m_Others = new List<GardenInsect>();
        private readonly List<GardenFlower> m_Flowers = new List<GardenFlower>();
        private readonly List<Object> m_Made = new List<Object>();

        // Above the flowers, so that insects come down to those on which they land and pass through none.
        private readonly FlightVolume m_Air = new FlightVolume(VolumeShape.Box, new Vector3(0f, 11.3f, 0f), new Vector3(36f, 9.4f, 36f));
        private readonly FlightVolume m_Night = new FlightVolume(VolumeShape.Box, new Vector3(0f, 8.6f, 0f), new Vector3(24f, 4f, 24f));
        private GardenFish m_Fish;
        private GardenLight m_Light;
        private OrbitCamera m_Camera;
        private Material m_Solid;
        private float m_Time;
        private int m_Followed;

        private void Awake()
        {
            m_Solid = Keep(WingMaterial.ForVertexColours(isWing: true, isTranslucent: false));
            Material clear = Keep(WingMaterial.ForVertexColours(isWing: true, isTranslucent: true));

            // Before the camera, which brings a light of its own where there is no sun.
            m_Light = new GardenLight(transform);
            m_Camera = OrbitCamera.Create(transform, transform.position + 5f * Vector3.up, k_CameraDistance);
            m_Camera.Pitch = 10f;
            Draw("Ground", Vector3.zero, Keep(GroundMesh.Ground(k_GardenRadius, k_PondRadius, k_PondDepth)), m_Solid);
            Draw("Grass", Vector3.zero, Keep(GroundMesh.Grass(k_GardenRadius, 1)), m_Solid);
            Draw("Shore", Vector3.zero, Keep(GroundMesh.Shore(k_PondRadius, 1)), m_Solid);
            Draw("Water", k_WaterDepth * Vector3.down, Keep(GroundMesh.Water(k_GardenRadius, k_PondRadius)),
                clear);
            BoxCollider ground = new GameObject("Ground Collider").AddComponent<BoxCollider>();
            ground.transform.SetParent(transform, false);
            ground.center = new Vector3(0f, -0.5f, 0f);
            ground.size = new Vector3(2f * k_GardenRadius, 1f, 2f * k_GardenRadius);
            for (int k = 0; k < k_Flowers; k++)
                Plant(k);
            Mesh glow = Keep(GlowMesh.Create());
            for (int k = 0; k < k_Fireflies; k++)
                m_Others.Add(GardenInsect.Firefly(transform, m_Night, 100 + k, glow, clear));
            m_Fish = new GardenFish(transform);
        }

        private void Update()
        {
            if (m_Butterflies.Count < m_Count)
                m_Butterflies.Add(Butterfly(m_Butterflies.Count));
            while (m_Butterflies.Count > m_Count)
            {
                m_Butterflies[m_Butterflies.Count - 1].Destroy();
                m_Butterflies.RemoveAt(m_Butterflies.Count - 1);
            }

            m_Time += Time.deltaTime;
            foreach (GardenFlower flower in m_Flowers)
                flower.Show(m_Time, m_Wind);
            Tell(m_Butterflies);
            Tell(m_Others);
            m_Light.Show(m_Dusk, m_Camera.GetComponent<Camera>());
            Follow();
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Count = Mathf.RoundToInt(m_Panel.Slider($"Butterflies: {m_Count}, {Sitting()} sit", m_Count, 0f, k_Most));
            m_Wind = m_Panel.Slider($"Wind: {m_Wind:0.0} m/s", m_Wind, 0f, 2f);
            m_Aid = m_Panel.Slider($"Aid: {m_Aid:0.00}", m_Aid, 0f, 1f);
            m_Dusk = m_Panel.Slider($"Dusk: {m_Dusk:0.00}", m_Dusk, 0f, 1f);
            m_Shy = m_Panel.Slider(m_Shy > 0f ? $"Shy: flee at {m_Shy:0.0}" : "Shy: not at all", m_Shy, 0f, k_MostShy);
            m_Watched = Mathf.RoundToInt(m_Panel.Slider(
                m_Watched > 0 ? $"Watch: number {m_Watched}" : "Watch: the garden", m_Watched, 0f, m_Count));
            m_Panel.Label("Come near with the camera: they flee");
            m_Panel.End();
        }

        private void OnDestroy()
        {
            foreach (GardenInsect insect in m_Butterflies)
                insect.Destroy();
            foreach (GardenInsect insect in m_Others)
                insect.Destroy();
            m_Fish.Destroy();
            m_Light.Restore();
            foreach (Object made in m_Made)
                Destroy(made);
        }

        private GardenInsect Butterfly(int number)
        {
            InsectDefinition species = InsectCatalogue.Find(number % 2 == 0 ? "monarch" : "swallowtail");
            return GardenInsect.Butterfly(species, transform, m_Air, m_Camera.transform, number + 1);
        }

        // A wind of the real insect's size: its metres are world units times ten.
        private void Tell(List<GardenInsect> insects)
        {
            foreach (GardenInsect insect in insects)
            {
                insect.Aid = m_Aid;
                insect.Shy = m_Shy;
                insect.Glow(m_Time, m_Dusk);
                insect.Wind = m_Wind * InsectDefinition.UnitsPerMetre * Vector3.right;
            }
        }

        // Comes near as another one is chosen; then the user's wheel counts.
        private void Follow()
        {
            if (m_Watched < 1 || m_Watched > m_Butterflies.Count)
            {
                m_Followed = 0;
                return;
            }

            if (m_Followed != m_Watched)
                m_Camera.Distance = Mathf.Min(m_Camera.Distance, k_NearDistance);
            m_Followed = m_Watched;
            float share = 1f - Mathf.Exp(-k_FollowRate * Time.deltaTime);
            m_Camera.Target = Vector3.Lerp(m_Camera.Target, m_Butterflies[m_Watched - 1].Position, share);
        }

        private int Sitting()
        {
            int count = 0;
            foreach (GardenInsect insect in m_Butterflies)
                count += insect.Sits ? 1 : 0;
            return count;
        }

        private void Plant(int number)
        {
            float angle = 137.5f * number, radius = 3.5f * Mathf.Sqrt(number + 1f), height = 3f + 0.37f * (number * 5 % 8);
            Vector3 place = Quaternion.Euler(0f, angle, 0f) * new Vector3(0f, height, radius);
            Mesh mesh = Keep(FlowerMesh.Create(1.1f, height, s_Petals[number % s_Petals.Length]));
            Transform flower = Draw($"Flower {number}", place, mesh, m_Solid);
            flower.localRotation = Quaternion.Euler(8f * (number % 3), angle, 0f);
            m_Flowers.Add(new GardenFlower(flower, height, number));
        }

        private Transform Draw(string name, Vector3 place, Mesh mesh, Material material)
        {
            var drawn = new GameObject(name);
            drawn.transform.SetParent(transform, false);
            drawn.transform.localPosition = place;
            drawn.AddComponent<MeshFilter>().sharedMesh = mesh;
            drawn.AddComponent<MeshRenderer>().sharedMaterial = material;
            return drawn.transform;
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }
    }
}
