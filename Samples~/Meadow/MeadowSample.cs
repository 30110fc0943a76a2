using Alate.Catalogue;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>Ten thousand monarchs and fireflies, baked as play begins; those nearest to the camera are live.</summary>
    [AddComponentMenu("Alate/Samples/Meadow Sample")]
    [DisallowMultipleComponent]
    public sealed class MeadowSample : MonoBehaviour
    {
        private const float k_CameraDistance = 9f, k_Radius = 45f, k_Smoothing = 0.05f;
        private const int k_Live = 4;

        [SerializeField, Range(1, 20000)]
        [Tooltip("Monarchs, 1 to 20000; 6000.")]
        private int m_Monarchs = 6000;

        [SerializeField, Range(1, 20000)]
        [Tooltip("Fireflies, 1 to 20000; 4000.")]
        private int m_Fireflies = 4000;

        private MeadowCrowd[] m_Crowds = System.Array.Empty<MeadowCrowd>();
        private float m_Time, m_FrameTime;

        private void Start()
        {
            OrbitCamera.Create(transform, transform.position + 2f * Vector3.up, k_CameraDistance);
            m_Crowds = new[]
            {
                new MeadowCrowd("monarch", m_Monarchs, k_Live, k_Radius, transform),
                new MeadowCrowd("firefly", m_Fireflies, k_Live, k_Radius, transform),
            };
        }

        private void Update()
        {
            m_Time += Time.deltaTime;
            foreach (MeadowCrowd crowd in m_Crowds)
                crowd.Fly(m_Time);
            m_FrameTime = Mathf.Lerp(m_FrameTime, 1000f * Time.unscaledDeltaTime, m_FrameTime > 0f ? k_Smoothing : 1f);
        }

        private void OnGUI()
        {
            GUILayout.BeginArea(new Rect(10f, 10f, 280f, 180f), GUI.skin.box);
            GUILayout.Label($"{m_FrameTime:0.0} ms a frame");
            foreach (MeadowCrowd shown in m_Crowds)
            {
                GUILayout.Label(
                    shown.Crowd.Problem ?? $"{shown.Crowd.DrawnCount} of {shown.Crowd.Count} baked in sight, {shown.Crowd.LiveNow} live");
                GUILayout.Label($"{shown.Crowd.DrawCalls} draw calls, {shown.Crowd.Triangles / 1000} thousand triangles");
            }

            GUILayout.Label($"Time × {Time.timeScale:0.00}");
            Time.timeScale = GUILayout.HorizontalSlider(Time.timeScale, 0f, 1f);
            GUILayout.EndArea();
        }

        private void OnDestroy()
        {
            Time.timeScale = 1f;
            foreach (MeadowCrowd crowd in m_Crowds)
                crowd.Destroy();
        }
    }
}
