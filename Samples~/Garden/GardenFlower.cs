using Alate.Flight;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A flower that the wind bends and sways about its foot, with the perch mark on its head that goes along.</summary>
    internal sealed class GardenFlower
    {
        /// <summary>Lean in a wind of 1 m/s, and how far to both sides of it the flower sways, degrees.</summary>
        private const float k_Lean = 1.5f, k_Sway = 2f;

        /// <summary>Sways of a flower as high as one unit in a second: higher ones are slower, as rods are.</summary>
        private const float k_Rate = 2.4f;

        private readonly Transform m_Flower;
        private readonly Vector3 m_Place, m_Foot;
        private readonly Quaternion m_Rotation;
        private readonly float m_Rate, m_Phase;

        /// <summary>Adds a mark to a flower whose origin is its head.</summary>
        /// <param name="flower">The flower, at rest.</param>
        /// <param name="height">Length of its stem, units of the scene.</param>
        /// <param name="number">Number of the flower: each has its own phase.</param>
        public GardenFlower(Transform flower, float height, int number)
        {
            m_Flower = flower;
            m_Place = flower.localPosition;
            m_Rotation = flower.localRotation;
            m_Foot = m_Place - m_Rotation * (height * Vector3.up);
            m_Rate = k_Rate / Mathf.Sqrt(height);
            m_Phase = 0.618f * number;
            Transform seat = new GameObject("Perch Mark").transform;
            seat.SetParent(flower, false);
            seat.gameObject.AddComponent<PerchMark>();
        }

        /// <summary>Bends the flower for a wind along X.</summary>
        /// <param name="time">Seconds.</param>
        /// <param name="wind">m/s of the real insect's size.</param>
        public void Show(float time, float wind)
        {
            if (wind == 0f)
            {
                m_Flower.localPosition = m_Place;
                m_Flower.localRotation = m_Rotation;
                return;
            }

            float angle = 2f * Mathf.PI * (m_Rate * time + m_Phase);
            var bend = Quaternion.Euler(
                wind * 0.5f * k_Sway * Mathf.Sin(0.8f * angle), 0f, -wind * (k_Lean + k_Sway * Mathf.Sin(angle)));
            m_Flower.localPosition = m_Foot + bend * (m_Place - m_Foot);
            m_Flower.localRotation = bend * m_Rotation;
        }
    }
}
