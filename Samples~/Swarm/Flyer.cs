using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>One insect of the swarm: it flies up and down on a circle of its own.</summary>
    internal sealed class Flyer
    {
        private const float k_Nearest = 1.5f, k_Farthest = 40f, k_Speed = 4f;

        private readonly InsectWings m_Insect;
        private readonly float m_Radius, m_Height, m_Start, m_Turn;

        /// <param name="species">Its name in the catalogue.</param>
        /// <param name="number">Each number flies another way, always the same.</param>
        /// <param name="parent">Of the insect.</param>
        public Flyer(string species, int number, Transform parent)
        {
            var random = new System.Random(number);
            float Between(float least, float most) => Mathf.Lerp(least, most, (float)random.NextDouble());

            // Denser towards the middle, so that every level of detail is seen.
            m_Radius = Between(k_Nearest, k_Farthest);
            m_Height = Between(-0.15f, 0.15f) * m_Radius;
            m_Start = Between(0f, 360f);
            m_Turn = (random.Next(2) == 0 ? 1f : -1f) * Mathf.Rad2Deg * k_Speed * Between(0.7f, 1.3f) / m_Radius;
            m_Insect = InsectFactory.Create(species);
            m_Insect.transform.SetParent(parent, false);
            m_Insect.UpdateMode = WingUpdateMode.Update;
            m_Insect.StartPhase = Between(0f, 360f);
            m_Insect.ResetState();
        }

        /// <summary>Level of detail with which the insect is computed.</summary>
        public WingDetail Detail => m_Insect.Detail;

        /// <summary>True where the insect may be computed with less detail where it is small.</summary>
        public bool UsesDetail
        {
            set => m_Insect.Quality.levelOfDetail = value;
        }

        /// <summary>True where the graphics card may deform its wings.</summary>
        public bool UsesCard
        {
            set => m_Insect.Quality.skinning = value ? WingSkinning.Automatic : WingSkinning.Cpu;
        }

        /// <summary>Moves it to where it is at a time, seconds.</summary>
        public void Fly(float time)
        {
            float angle = m_Start + m_Turn * time;
            var round = Quaternion.Euler(0f, angle, 0f);
            float rise = 0.05f * m_Radius * Mathf.Sin(3f * Mathf.Deg2Rad * angle);
            Transform body = m_Insect.transform;
            body.localPosition = round * new Vector3(m_Radius, 0f, 0f) + (m_Height + rise) * Vector3.up;
            body.localRotation = round * Quaternion.Euler(-10f, m_Turn > 0f ? 180f : 0f, 0f);
        }

        /// <summary>Colours its wings.</summary>
        /// <param name="tint">Properties of a renderer of its own.</param>
        /// <param name="instanceTint">Properties of an instance, where the graphics card deforms the wings.</param>
        public void Tint(MaterialPropertyBlock tint, MaterialPropertyBlock instanceTint)
        {
            bool onCard = m_Insect.Quality.skinning != WingSkinning.Cpu && m_Insect.SkinningObstacle.Length == 0;
            foreach (Wing wing in m_Insect.Wings)
                wing.Renderer.SetPropertyBlock(onCard ? instanceTint : tint);
        }

        /// <summary>Ends it.</summary>
        public void Destroy() => Object.Destroy(m_Insect.gameObject);
    }
}
