using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Crowds
{
    /// <summary>
    /// Tells of each camera that is about to cull its scene, in the built-in pipeline and in those of scripts; of a probe's, which turns to
    /// six sides, once a frame, as calls for a camera last until the frame ends.
    /// </summary>
    internal sealed class CrowdCameras : IDisposable
    {
        private readonly Action<Camera> m_Draw;
        private readonly GameObject m_Owner;
        private readonly List<Camera> m_Probes = new List<Camera>();
        private int m_Frame;

        /// <param name="owner">What is drawn: its layer and scene decide which cameras see it.</param>
        /// <param name="draw">Draws for a camera.</param>
        public CrowdCameras(GameObject owner, Action<Camera> draw)
        {
            m_Owner = owner;
            m_Draw = draw;
            Camera.onPreCull += Begin;
            RenderPipelineManager.beginCameraRendering += BeginInPipeline;
        }

        /// <summary>Ends it.</summary>
        public void Dispose()
        {
            Camera.onPreCull -= Begin;
            RenderPipelineManager.beginCameraRendering -= BeginInPipeline;
        }

        private void BeginInPipeline(ScriptableRenderContext context, Camera camera) => Begin(camera);

        private void Begin(Camera camera)
        {
            if (!MaySee(camera))
                return;
            if (m_Frame != Time.frameCount)
                m_Probes.Clear();
            m_Frame = Time.frameCount;
            if (camera.cameraType == CameraType.Reflection)
            {
                if (m_Probes.Contains(camera))
                    return;
                m_Probes.Add(camera);
            }

            m_Draw(camera);
        }

        // Previews and the prefab stage have scenes of their own, which the engine does not ask of calls for one camera.
        private bool MaySee(Camera camera)
        {
            if (camera.cameraType == CameraType.Preview || (camera.cullingMask & (1 << m_Owner.layer)) == 0)
                return false;
            ulong stage = camera.overrideSceneCullingMask;
            return stage == 0 || (stage & m_Owner.sceneCullingMask) != 0;
        }
    }
}
