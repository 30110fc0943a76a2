using Alate.Catalogue;
using Alate.Showcase;
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

        private readonly ScreenPanel m_Panel = new ScreenPanel(280f);
        private MeadowCrowd[] m_Crowds = System.Array.Empty<MeadowCrowd>();
        private Mesh m_Ground;
        private Material m_Grass;
        private float m_Time, m_FrameTime;

        private void Start()
        {
            OrbitCamera.Create(transform, transform.position + 2f * Vector3.up, k_CameraDistance).Pitch = 15f;
            m_Ground = MeadowGround.Create(2f * k_Radius);
            m_Grass = WingMaterial.ForVertexColours(isWing: true, isTranslucent: false);
            var ground = new GameObject("Ground");
            ground.transform.SetParent(transform, false);
            ground.AddComponent<MeshFilter>().sharedMesh = m_Ground;
            ground.AddComponent<MeshRenderer>().sharedMaterial = m_Grass;
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
            if (!m_Panel.Begin())
                return;
            m_Panel.Label($"{m_FrameTime:0.0} ms a frame");
            foreach (MeadowCrowd shown in m_Crowds)
            {
                m_Panel.Label(
                    shown.Crowd.Problem ?? $"{shown.Crowd.DrawnCount} of {shown.Crowd.Count} baked in sight, {shown.Crowd.LiveNow} live");
                m_Panel.Label($"{shown.Crowd.DrawCalls} draw calls, {shown.Crowd.Triangles / 1000} thousand triangles");
            }

            Time.timeScale = m_Panel.Slider($"Time × {Time.timeScale:0.00}", Time.timeScale, 0f, 1f);
            m_Panel.End();
        }

        private void OnDestroy()
        {
            Time.timeScale = 1f;
            foreach (MeadowCrowd crowd in m_Crowds)
                crowd.Destroy();
            Destroy(m_Ground);
            Destroy(m_Grass);
        }
    }
}
