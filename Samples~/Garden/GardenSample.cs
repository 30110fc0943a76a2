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
        private const int k_Most = 60, k_Flowers = 16;
        private const float k_CameraDistance = 30f, k_GardenRadius = 16f, k_PondRadius = 30f, k_PondDepth = 8f;

        private static readonly Color[] s_Petals =
        {
            new Color(0.9f, 0.4f, 0.6f), new Color(0.95f, 0.85f, 0.3f), new Color(0.75f, 0.6f, 0.95f), new Color(0.95f, 0.95f, 0.9f),
        };

        [SerializeField, Range(0, k_Most)]
        [Tooltip("Butterflies, 0 to 60; 8.")]
        private int m_Count = 8;

        [SerializeField, Range(0f, 2f)]
        [Tooltip("Metres per second of wind along X, 0 to 2; 0.")]
        private readonly ScreenPanel m_Panel = new ScreenPanel(280f);
        private float m_Wind;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("Help from outside after a tumble, 0 to 1; 0.3. 0 flies by the wings alone.")]
        private float m_Aid = 0.3f;

        [SerializeField, Range(0f, 1f)]
        [Tooltip("0 by day, 1 at night: fireflies blink.")]
        private float m_Dusk = 0.3f;

        private readonly List<GardenInsect> m_Butterflies = new List<GardenInsect>(), m_Others = new List<GardenInsect>();
        private readonly List<Object> m_Made = new List<Object>();
        private readonly FlightVolume m_Air = new FlightVolume(VolumeShape.Box, new Vector3(0f, 9f, 0f), new Vector3(36f, 14f, 36f));
        private readonly FlightVolume m_Night = new FlightVolume(VolumeShape.Box, new Vector3(0f, 5f, 0f), new Vector3(24f, 6f, 24f));
        private GardenFish m_Fish;
        private OrbitCamera m_Camera;
        private Material m_Solid;
        private float m_Time;

        private void Awake()
        {
            m_Solid = Keep(WingMaterial.ForVertexColours(isWing: true, isTranslucent: false));
            m_Camera = OrbitCamera.Create(transform, transform.position + 6f * Vector3.up, k_CameraDistance);
            Draw("Ground", Vector3.zero, Keep(FlowerMesh.Plate(k_GardenRadius, new Color(0.36f, 0.5f, 0.24f))));
            Draw("Pond", k_PondDepth * Vector3.down, Keep(FlowerMesh.Plate(k_PondRadius, new Color(0.2f, 0.36f, 0.42f))));
            BoxCollider ground = new GameObject("Ground Collider").AddComponent<BoxCollider>();
            ground.transform.SetParent(transform, false);
            ground.center = new Vector3(0f, -0.5f, 0f);
            ground.size = new Vector3(2f * k_GardenRadius, 1f, 2f * k_GardenRadius);
            for (int k = 0; k < k_Flowers; k++)
                Plant(k);
            for (int k = 0; k < 3; k++)
                m_Others.Add(GardenInsect.Wanderer(InsectCatalogue.Find("firefly"), transform, m_Night, 100 + k));
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
            Tell(m_Butterflies);
            Tell(m_Others);
            m_Camera.GetComponent<Camera>().backgroundColor = Color.Lerp(
                new Color(0.62f, 0.68f, 0.7f), new Color(0.07f, 0.08f, 0.16f), m_Dusk);
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Count = Mathf.RoundToInt(m_Panel.Slider($"Butterflies: {m_Count}, {Sitting()} sit", m_Count, 0f, k_Most));
            m_Wind = m_Panel.Slider($"Wind: {m_Wind:0.0} m/s", m_Wind, 0f, 2f);
            m_Aid = m_Panel.Slider($"Aid: {m_Aid:0.00}", m_Aid, 0f, 1f);
            m_Dusk = m_Panel.Slider($"Dusk: {m_Dusk:0.00}", m_Dusk, 0f, 1f);
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
                insect.Glow(m_Time, m_Dusk);
                insect.Wind = m_Wind * InsectDefinition.UnitsPerMetre * Vector3.right;
            }
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
            Transform flower = Draw($"Flower {number}", place, Keep(FlowerMesh.Flower(1.1f, height, s_Petals[number % s_Petals.Length])));
            flower.localRotation = Quaternion.Euler(8f * (number % 3), angle, 0f);
            Transform seat = new GameObject("Perch Mark").transform;
            seat.SetParent(flower, false);
            seat.gameObject.AddComponent<PerchMark>();
        }

        private Transform Draw(string name, Vector3 place, Mesh mesh)
        {
            var drawn = new GameObject(name);
            drawn.transform.SetParent(transform, false);
            drawn.transform.localPosition = place;
            drawn.AddComponent<MeshFilter>().sharedMesh = mesh;
            drawn.AddComponent<MeshRenderer>().sharedMaterial = m_Solid;
            return drawn.transform;
        }

        private T Keep<T>(T made) where T : Object
        {
            m_Made.Add(made);
            return made;
        }
    }
}
