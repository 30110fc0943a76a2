using System.Collections.Generic;
using Alate.Showcase;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// Up to a thousand insects that fly round the camera's point of view, with the level of detail of each shown by its colour, the time
    /// of a frame, and a budget for it.
    /// </summary>
    [AddComponentMenu("Alate/Samples/Swarm Sample")]
    [DisallowMultipleComponent]
    public sealed class SwarmSample : MonoBehaviour
    {
        private const float k_CameraDistance = 9f, k_Smoothing = 0.05f, k_MostBudget = 20f;
        private const int k_Most = 1000;

        private static readonly string[] s_Species = { "monarch", "painted-lichen-moth", "fishfly" };

        // Full, fewer substeps, coarse patches, waves only, frozen.
        private static readonly Color[] s_Colours =
        {
            new Color(1f, 0.45f, 0.4f), new Color(1f, 0.8f, 0.35f), new Color(0.6f, 0.9f, 0.45f), new Color(0.45f, 0.75f, 1f),
            new Color(0.6f, 0.6f, 0.65f),
        };

        [SerializeField, Range(1, k_Most)]
        [Tooltip("Insects, 1 to 1000; 300.")]
        private int m_Count = 300;

        private readonly ScreenPanel m_Panel = new ScreenPanel(280f);
        private readonly List<Flyer> m_Flyers = new List<Flyer>();
        private readonly int[] m_PerDetail = new int[s_Colours.Length];
        private MaterialPropertyBlock m_Tint, m_InstanceTint;
        private bool m_ShowsDetail = true, m_UsesDetail = true, m_UsesCard = true;
        private float m_FrameTime, m_Time;

        /// <summary>Number of insects, 1 to 1000.</summary>
        public int Count
        {
            get => m_Count;
            set => m_Count = Mathf.Clamp(value, 1, k_Most);
        }

        private void Awake()
        {
            m_Tint = new MaterialPropertyBlock();
            m_InstanceTint = new MaterialPropertyBlock();
            OrbitCamera.Create(transform, transform.position, k_CameraDistance);
        }

        private void Update()
        {
            // A few a frame, so that a thousand new insects are no hitch.
            for (int made = 0; m_Flyers.Count < m_Count && made < 20; made++)
                m_Flyers.Add(new Flyer(s_Species[m_Flyers.Count % s_Species.Length], m_Flyers.Count, transform));
            while (m_Flyers.Count > m_Count)
            {
                m_Flyers[m_Flyers.Count - 1].Destroy();
                m_Flyers.RemoveAt(m_Flyers.Count - 1);
            }

            m_Time += Time.deltaTime;
            System.Array.Clear(m_PerDetail, 0, m_PerDetail.Length);
            foreach (Flyer flyer in m_Flyers)
            {
                flyer.Fly(m_Time);
                flyer.UsesDetail = m_UsesDetail;
                flyer.UsesCard = m_UsesCard;
                int detail = (int)flyer.Detail;
                m_PerDetail[detail]++;
                Tint(m_ShowsDetail ? s_Colours[detail] : Color.white);
                flyer.Tint(m_Tint, m_InstanceTint);
            }

            m_FrameTime = Mathf.Lerp(m_FrameTime, 1000f * Time.unscaledDeltaTime, m_FrameTime > 0f ? k_Smoothing : 1f);
        }

        private void OnGUI()
        {
            if (!m_Panel.Begin())
                return;
            m_Panel.Label($"{m_FrameTime:0.0} ms a frame, {WingSystem.InsectCount} insects beat");
            m_Panel.Label($"{WingSystem.MeanTime:0.0} ms of it for their wings");
            Count = Mathf.RoundToInt(m_Panel.Slider($"Insects: {m_Count}", m_Count, 1f, k_Most));
            Time.timeScale = m_Panel.Slider($"Time × {Time.timeScale:0.00}", Time.timeScale, 0f, 1f);
            float budget = WingSystem.Budget;
            WingSystem.Budget = m_Panel.Slider(budget > 0f ? $"Budget: {budget:0.0} ms" : "Budget: none", budget, 0f, k_MostBudget);
            m_UsesCard = m_Panel.Toggle("Deformed by the graphics card", m_UsesCard);
            m_UsesDetail = m_Panel.Toggle("Level of detail", m_UsesDetail);
            m_ShowsDetail = m_Panel.Toggle("Show it by colours", m_ShowsDetail);
            for (int detail = 0; detail < s_Colours.Length; detail++)
            {
                GUI.contentColor = m_ShowsDetail ? s_Colours[detail] : Color.white;
                m_Panel.Label(
                    $"{m_PerDetail[detail]} {(WingDetail)detail}{(detail == (int)WingDetail.Frozen ? " or out of sight" : "")}");
            }

            GUI.contentColor = Color.white;
            m_Panel.End();
        }

        private void OnDestroy()
        {
            Time.timeScale = 1f;
            WingSystem.Budget = 0f;
        }

        // The package's own shader calls it _Color, those of URP and HDRP _BaseColor.
        private void Tint(Color colour)
        {
            m_Tint.SetColor("_Color", colour);
            m_Tint.SetColor("_BaseColor", colour);
            m_InstanceTint.SetColor("_SkinTint", colour);
        }
    }
}
