using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A snailfish that swims round and round: its fins feel the water, its way is given.</summary>
    internal sealed class GardenFish
    {
        private const float k_Radius = 8f, k_Speed = 1f, k_Depth = -5f;

        private readonly InsectWings m_Fins;

        /// <param name="parent">Of the fish.</param>
        public GardenFish(Transform parent)
        {
            m_Fins = InsectFactory.Create("snailfish");
            m_Fins.transform.SetParent(parent, false);
            m_Fins.UpdateMode = WingUpdateMode.Update;
        }

        /// <summary>Moves the fish to where it is at a time, seconds.</summary>
        public void Swim(float time)
        {
            float angle = Mathf.Rad2Deg * k_Speed / k_Radius * time;
            var round = Quaternion.Euler(0f, angle, 0f);
            m_Fins.transform.localPosition = round * new Vector3(-k_Radius, 0f, 0f) + (k_Depth + 0.5f * Mathf.Sin(0.7f * time)) * Vector3.up;
            m_Fins.transform.localRotation = round;
        }

        /// <summary>Ends the fish.</summary>
        public void Destroy() => Object.Destroy(m_Fins.gameObject);
    }
}
