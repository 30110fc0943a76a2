using System;
using Unity.Collections;
using UnityEngine;

namespace Alate
{
    /// <summary>Drawn mesh of a living insect, with the wings on it: swaps the authored mesh for a deformable copy, and back.</summary>
    internal sealed class LiveMesh
    {
        public readonly MeshFilter filter;
        public readonly MeshRenderer renderer;
        public readonly MeshTemplate template;
        public readonly LiveWing[] wings;
        private readonly int m_Patches;
        private readonly Mesh m_Copy;
        private readonly bool m_Moves;
        private readonly int m_DisplacementStream;
        private readonly MotionVectorGenerationMode m_Mode;
        private bool m_Moving;

        public LiveMesh(MeshFilter filter, MeshTemplate template, Wing[] wings, SkeletonValue[] skeletons, int patches, bool moves)
        {
            this.filter = filter;
            m_Patches = patches;
            this.template = template;
            renderer = wings[0].Renderer;
            m_Moves = moves;
            moves &= DeformableMesh.CanMove;
            this.wings = new LiveWing[wings.Length];
            VertexPacking packing = !template.IsPacked ? VertexPacking.None
                : MaterialTangents.AreRead(renderer) ? VertexPacking.NormalsAndTangents : VertexPacking.Normals;
            for (int w = 0; w < wings.Length; w++)
            {
                wings[w].Authored = template.Source;
                this.wings[w] = new LiveWing(wings[w], skeletons[w], template, w, packing, moves);
            }

            m_Copy = template.CreateCopy(moves);
            m_DisplacementStream = moves ? m_Copy.GetVertexAttributeStream(DeformableMesh.DisplacementAttribute) : 0;
            LivingMeshes.Add(m_Copy, template.Source, filter);
            filter.sharedMesh = m_Copy;
            m_Mode = renderer.motionVectorGenerationMode;
            if (moves)
                renderer.motionVectorGenerationMode = MotionVectorGenerationMode.Object;
        }

        /// <summary>
        /// Returns true where the filter still shows the copy (a script may have given it another mesh), made of the current content of the
        /// authored mesh with the insect's number of patches, and with displacements where it wants motion vectors.
        /// </summary>
        public bool IsCurrent(InsectWings insect) =>
            insect.Patches == m_Patches && insect.Quality.motionVectors == m_Moves && !template.IsOutdated
            && filter != null && renderer != null && ReferenceEquals(filter.sharedMesh, m_Copy);

        /// <summary>Uploads the deformed vertices of all wings to the mesh.</summary>
        public void Upload(WingWorld world)
        {
            foreach (LiveWing wing in wings)
            {
                if (template.IsPacked)
                {
                    Upload(world.PackedVertices(wing.handle), wing.start, DeformableMesh.VertexStream);
                    Upload(world.PackedTangents(wing.handle), wing.start, DeformableMesh.TangentStream);
                }
                else
                {
                    Upload(world.Vertices(wing.handle), wing.start, DeformableMesh.VertexStream);
                    Upload(world.Tangents(wing.handle), wing.start, DeformableMesh.TangentStream);
                }

                if (wing.moves)
                {
                    Upload(world.Displacements(wing.handle), wing.start, m_DisplacementStream);
                    world.TakePicture(wing.handle);
                    m_Moving = true;
                }
            }
        }

        /// <summary>Takes away the displacements of the last upload: the vertices stay as they are.</summary>
        public void Stop(WingWorld world)
        {
            if (!m_Moving)
                return;
            m_Moving = false;
            foreach (LiveWing wing in wings)
            {
                world.StopDisplacements(wing.handle);
                Upload(world.Displacements(wing.handle), wing.start, m_DisplacementStream);
            }
        }

        /// <summary>Gives the filter its authored mesh back, unless a script gave it another, and destroys the copy.</summary>
        public void Restore()
        {
            if (filter != null && IsOfThisWing(filter.sharedMesh))
                filter.sharedMesh = template.Source;
            if (m_Moves && renderer != null)
                renderer.motionVectorGenerationMode = m_Mode;
            foreach (LiveWing wing in wings)
                wing.ForgetAuthored();
            LivingMeshes.Remove(m_Copy);
            ObjectEnd.Destroy(m_Copy);
        }

        private void Upload<T>(NativeArray<T> values, int start, int stream) where T : struct
        {
            if (values.IsCreated)
                m_Copy.SetVertexBufferData(values, 0, start, values.Length, stream, DeformableMesh.UploadFlags);
        }

        // MeshFilter.mesh makes a duplicate and shows that instead: a frozen, bent wing that must not be taken for an authored one.
        private bool IsOfThisWing(Mesh shown) =>
            ReferenceEquals(shown, m_Copy) || (shown != null && shown.name.StartsWith(m_Copy.name, StringComparison.Ordinal));
    }
}
