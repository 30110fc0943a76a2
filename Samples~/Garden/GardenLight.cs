using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Samples
{
    /// <summary>Light of the garden from noon to night: a sun that sinks, and what comes from all around.</summary>
    internal sealed class GardenLight
    {
        private static readonly Color s_Noon = new Color(1f, 0.96f, 0.88f), s_Evening = new Color(1f, 0.6f, 0.35f),
            s_Moon = new Color(0.5f, 0.6f, 0.9f), s_Day = new Color(0.62f, 0.72f, 0.8f), s_Night = new Color(0.05f, 0.06f, 0.13f);

        private readonly Light m_Sun;
        private readonly AmbientMode m_Mode;
        private readonly Color m_Sky, m_Equator, m_Ground;

        /// <param name="parent">Of the sun.</param>
        public GardenLight(Transform parent)
        {
            m_Sun = new GameObject("Sun").AddComponent<Light>();
            m_Sun.transform.SetParent(parent, false);
            m_Sun.type = LightType.Directional;
            m_Sun.shadows = LightShadows.Soft;
            (m_Mode, m_Sky) = (RenderSettings.ambientMode, RenderSettings.ambientSkyColor);
            (m_Equator, m_Ground) = (RenderSettings.ambientEquatorColor, RenderSettings.ambientGroundColor);
        }

        /// <summary>Shows an hour.</summary>
        /// <param name="dusk">0 by day to 1 at night.</param>
        /// <param name="camera">Its background becomes the sky.</param>
        public void Show(float dusk, Camera camera)
        {
            // The sun is low at a half; from there on the moon shines.
            float evening = Mathf.Clamp01(2f * dusk), night = Mathf.Clamp01(2f * dusk - 1f);
            m_Sun.transform.localRotation = Quaternion.Euler(Mathf.Lerp(Mathf.Lerp(55f, 12f, evening), 40f, night), 40f, 0f);
            m_Sun.color = Color.Lerp(Color.Lerp(s_Noon, s_Evening, evening), s_Moon, night);
            m_Sun.intensity = Mathf.Lerp(Mathf.Lerp(1.3f, 0.8f, evening), 0.12f, night);
            camera.backgroundColor = Color.Lerp(Color.Lerp(s_Day, s_Day * 0.8f, evening), s_Night, night);
            float around = Mathf.Lerp(1f, 0.3f, night);
            RenderSettings.ambientMode = AmbientMode.Trilight;
            RenderSettings.ambientSkyColor = new Color(0.5f, 0.56f, 0.64f) * around;
            RenderSettings.ambientEquatorColor = new Color(0.42f, 0.44f, 0.44f) * around;
            RenderSettings.ambientGroundColor = new Color(0.24f, 0.26f, 0.18f) * around;
        }

        /// <summary>Gives back the light that the scene had.</summary>
        public void Restore()
        {
            (RenderSettings.ambientMode, RenderSettings.ambientSkyColor) = (m_Mode, m_Sky);
            (RenderSettings.ambientEquatorColor, RenderSettings.ambientGroundColor) = (m_Equator, m_Ground);
        }
    }
}
