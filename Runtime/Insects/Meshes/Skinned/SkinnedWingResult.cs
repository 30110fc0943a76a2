using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>Result of converting a skinned renderer whose wings are now plain renderers.</summary>
    public sealed class SkinnedWingResult
    {
        private readonly Mesh m_Original;
        private readonly bool m_WasEnabled;
        private readonly IReadOnlyList<LODGroup> m_Groups;
        private bool m_IsRestored;

        internal SkinnedWingResult(
            SkinnedMeshRenderer source, IReadOnlyList<MeshRenderer> wings, IReadOnlyList<Mesh> wingMeshes, Mesh bodyMesh)
        {
            Source = source;
            Wings = wings;
            WingMeshes = wingMeshes;
            BodyMesh = bodyMesh;
            m_Original = source.sharedMesh;
            m_WasEnabled = source.enabled;
            m_Groups = DetailLevels.Above(source);
        }

        /// <summary>Skinned renderer of the source. It draws the body, or is disabled if the mesh was all wing.</summary>
        public SkinnedMeshRenderer Source { get; }

        /// <summary>The new renderers, one a wing, under the bones that carry them: fore right, fore left, hind right, hind left.</summary>
        public IReadOnlyList<MeshRenderer> Wings { get; }

        /// <summary>
        /// New meshes of the wings, in the order of <see cref="Wings"/>. They are no assets: save them, or destroy them with the wings.
        /// </summary>
        public IReadOnlyList<Mesh> WingMeshes { get; }

        /// <summary>New mesh of the body, skinned as before; null if the mesh was all wing. It is no asset either.</summary>
        public Mesh BodyMesh { get; }

        /// <summary>
        /// Undoes the conversion at run time: gives the renderer its mesh back, destroys the new objects and meshes. In the editor use Undo
        /// instead, above all once the meshes have been saved. A second call does nothing.
        /// </summary>
        public void Restore()
        {
            if (m_IsRestored)
                return;
            m_IsRestored = true;
            foreach (LODGroup group in m_Groups)
            {
                if (group != null)
                    DetailLevels.Remove(group, Wings);
            }

            if (Source != null)
            {
                Source.sharedMesh = m_Original;
                Source.enabled = m_WasEnabled;
            }

            foreach (MeshRenderer wing in Wings)
            {
                if (wing != null)
                    ObjectEnd.Destroy(wing.gameObject);
            }

            foreach (Mesh mesh in WingMeshes)
                ObjectEnd.Destroy(mesh);
            ObjectEnd.Destroy(BodyMesh);
        }

        internal void Apply()
        {
            foreach (LODGroup group in m_Groups)
                DetailLevels.Add(group, Source, Wings);
            if (BodyMesh != null)
                Source.sharedMesh = BodyMesh;
            else
                Source.enabled = false;
        }
    }
}
