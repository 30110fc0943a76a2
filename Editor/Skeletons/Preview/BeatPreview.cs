using System;
using Unity.Collections;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Shape of a wing at a phase of its beat, for skeletons under edit: bakes a rig, lets it beat until it has settled, and steps to the
    /// wanted phase. Owns a world and a mesh that is never saved; dispose it.
    /// </summary>
    internal sealed class BeatPreview : IDisposable
    {
        /// <summary>Number of patches that meet the air: enough for a picture, and quicker than the rig's default.</summary>
        public const int Patches = 96;

        /// <summary>
        /// Number of beats from rest until the picture counts as settled; the tip is then within a few per cent of its final motion.
        /// </summary>
        public const int SettleBeats = 3;

        private const float k_TwoPi = 2f * math.PI;

        /// <summary>Tolerance of the phase, as a share of the beat.</summary>
        private const float k_PhaseTolerance = 1e-3f;

        private WingWorld m_World;
        private WingHandle m_Wing;
        private Mesh m_Mesh;

        /// <summary>Reason why there is no picture, one sentence; null while there is one, and before <see cref="Bake"/>.</summary>
        public string Problem { get; private set; }

        /// <summary>True where there is a picture.</summary>
        public bool IsReady => m_World != null;

        /// <summary>
        /// The deformed wing in the space of its mesh; null where there is no picture. Changed in place by <see cref="Show"/>.
        /// </summary>
        public Mesh Mesh => IsReady ? m_Mesh : null;

        /// <summary>The phase that the picture shows, as a share of the beat from 0 to 1.</summary>
        public float Phase => m_World.Read(m_Wing).Phase / k_TwoPi;

        /// <summary>Bakes the present skeleton. A skeleton that cannot be baked leaves no picture and a <see cref="Problem"/>.</summary>
        /// <param name="skeleton">The skeleton.</param>
        /// <param name="surface">The wing's triangles, in the skeleton's space.</param>
        /// <param name="flight">How it beats.</param>
        public void Bake(WingSkeleton skeleton, SurfaceMesh surface, in PreviewFlight flight)
        {
            Clear();
            WingRig rig;
            try
            {
                rig = WingRig.Bake(skeleton, surface, new WingRigSettings { patchCount = Patches });
            }
            catch (ArgumentException refused)
            {
                Problem = refused.Message;
                return;
            }

            m_World = new WingWorld();
            m_Wing = m_World.Add(rig, flight.parameters, flight.surroundings);
            rig.Release();
            for (int beat = 0; beat < SettleBeats; beat++)
                m_World.Step(1f / m_World.Read(m_Wing).Frequency);
            Fill(surface);
        }

        /// <summary>Steps forward to a phase, by less than one beat.</summary>
        /// <param name="phase">Share of the beat; only its fraction counts.</param>
        public void Show(float phase)
        {
            if (!IsReady)
                return;
            for (int tries = 0; tries < 3; tries++)
            {
                float ahead = math.frac(phase - Phase);
                if (ahead < k_PhaseTolerance || ahead > 1f - k_PhaseTolerance)
                    break;
                m_World.Step(ahead / m_World.Read(m_Wing).Frequency);
            }

            m_World.Skin();
            NativeArray<SkinnedVertex> vertices = m_World.Vertices(m_Wing);
            m_Mesh.SetVertexBufferData(vertices, 0, 0, vertices.Length);
            m_Mesh.bounds = m_World.Bounds(m_Wing);
        }

        /// <summary>Frees the world and the mesh.</summary>
        public void Dispose()
        {
            Clear();
            if (m_Mesh != null)
                Object.DestroyImmediate(m_Mesh);
            m_Mesh = null;
        }

        /// <summary>Frees the world; there is no picture until the next one is baked.</summary>
        public void Clear()
        {
            m_World?.Dispose();
            m_World = null;
            Problem = null;
        }

        private void Fill(SurfaceMesh surface)
        {
            if (m_Mesh == null)
                m_Mesh = new Mesh { name = "Beat Preview", hideFlags = HideFlags.HideAndDontSave };
            m_Mesh.Clear();
            m_Mesh.indexFormat = surface.positions.Length > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16;
            m_Mesh.SetVertexBufferParams(
                surface.positions.Length,
                new VertexAttributeDescriptor(VertexAttribute.Position, VertexAttributeFormat.Float32, 3),
                new VertexAttributeDescriptor(VertexAttribute.Normal, VertexAttributeFormat.Float32, 3));
            m_Mesh.SetTriangles(surface.triangles, 0, false);
        }
    }
}
