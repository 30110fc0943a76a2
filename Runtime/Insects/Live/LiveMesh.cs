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

        public LiveMesh(MeshFilter filter, MeshTemplate template, Wing[] wings, SkeletonValue[] skeletons, int patches)
        {
            this.filter = filter;
            m_Patches = patches;
            this.template = template;
            renderer = wings[0].Renderer;
            this.wings = new LiveWing[wings.Length];
            VertexPacking packing = !template.IsPacked ? VertexPacking.None
                : MaterialTangents.AreRead(renderer) ? VertexPacking.NormalsAndTangents : VertexPacking.Normals;
            for (int w = 0; w < wings.Length; w++)
            {
                wings[w].Authored = template.Source;
                this.wings[w] = new LiveWing(wings[w], skeletons[w], template, w, packing);
            }

            m_Copy = template.CreateCopy();
            LivingMeshes.Add(m_Copy, template.Source, filter);
            filter.sharedMesh = m_Copy;
        }

        /// <summary>
        /// Returns true where the filter still shows the copy (a script may have given it another mesh), made of the current content of the
        /// authored mesh with this number of patches.
        /// </summary>
        public bool IsCurrent(int patches) =>
            patches == m_Patches && !template.IsOutdated && filter != null && renderer != null
            && ReferenceEquals(filter.sharedMesh, m_Copy);

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
            }
        }

        /// <summary>Gives the filter its authored mesh back, unless a script gave it another, and destroys the copy.</summary>
        public void Restore()
        {
            if (filter != null && IsOfThisWing(filter.sharedMesh))
                filter.sharedMesh = template.Source;
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
