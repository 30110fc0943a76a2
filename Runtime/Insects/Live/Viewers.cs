using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Cameras by which levels of detail are chosen, as sampled in a frame.</summary>
    internal sealed class Viewers
    {
        private readonly List<Viewer> m_Viewers = new List<Viewer>();

        /// <summary>Time that the wings may take.</summary>
        public DetailBudget Budget { get; } = new DetailBudget();

        /// <summary>True where there is a camera.</summary>
        public bool Any => m_Viewers.Count > 0;

        /// <summary>Samples the positions of the cameras.</summary>
        public void UpdateCameras()
        {
            m_Viewers.Clear();
            float bias = QualitySettings.lodBias;
            foreach (Camera camera in WingSystem.DetailCameras)
            {
                if (camera != null)
                    m_Viewers.Add(new Viewer(camera, bias));
            }

            if (!Any && Camera.main is { } main && main != null)
                m_Viewers.Add(new Viewer(main, bias));
        }

        /// <summary>Largest share of a screen's height that a sphere fills, times the LOD bias of the quality settings.</summary>
        public float ScreenHeight(float3 centre, float radius)
        {
            float largest = 0f;
            foreach (Viewer viewer in m_Viewers)
                largest = math.max(largest, viewer.ScreenHeight(centre, radius));
            return largest;
        }

        private readonly struct Viewer
        {
            private readonly float3 m_Position;
            private readonly bool m_IsParallel;
            private readonly float m_Factor;

            public Viewer(Camera camera, float bias)
            {
                m_Position = camera.transform.position;
                m_IsParallel = camera.orthographic;
                m_Factor = bias / (m_IsParallel ? camera.orthographicSize : Elementary.Tan(0.5f * math.radians(camera.fieldOfView)));
            }

            public float ScreenHeight(float3 centre, float radius) =>
                m_Factor * (m_IsParallel ? radius : radius / math.max(math.distance(centre, m_Position), 1e-6f));
        }
    }
}
