using System;
using UnityEngine;

namespace Alate
{
    /// <summary>Drawn mesh of a living insect, with the wings on it: swaps the authored mesh for a living one, and back.</summary>
    internal sealed class LiveMesh
    {
        public readonly MeshFilter filter;
        public readonly MeshRenderer renderer;
        public readonly MeshTemplate template;
        public readonly LiveWing[] wings;
        private readonly ShownWings m_Shown;
        private readonly Mesh m_Mesh;
        private readonly int m_Patches;
        private readonly bool m_Moves, m_HasLevels;
        private readonly WingSkinning m_Skinning;
        private readonly MotionVectorGenerationMode m_Mode;

        public LiveMesh(
            MeshFilter filter, MeshTemplate template, Wing[] wings, SkeletonValue[] skeletons, InsectWings insect, GpuSkins skins)
        {
            this.filter = filter;
            this.template = template;
            renderer = wings[0].Renderer;
            m_Patches = insect.Patches;
            m_Moves = insect.Quality.motionVectors;
            m_HasLevels = insect.Quality.levelOfDetail;
            m_Skinning = insect.Quality.skinning;
            string obstacle = null;
            if (m_Skinning != WingSkinning.Cpu)
                m_Shown = GpuWings.TryMake(template, renderer, skins, m_Moves, out obstacle);
            Obstacle = obstacle;
            m_Shown ??= new CpuWings(template, renderer, m_Moves);
            m_Mesh = m_Shown.Mesh;
            this.wings = new LiveWing[wings.Length];
            for (int w = 0; w < wings.Length; w++)
            {
                wings[w].Authored = template.Source;
                this.wings[w] = new LiveWing(wings[w], skeletons[w], template, w, m_Shown);
            }

            m_Shown.Begin(this.wings);
            LivingMeshes.Add(m_Mesh, template.Source, filter);
            filter.sharedMesh = m_Mesh;
            m_Mode = renderer.motionVectorGenerationMode;
            if (m_Moves)
                renderer.motionVectorGenerationMode = MotionVectorGenerationMode.Object;
        }

        /// <summary>
        /// Reason why the processor deforms the mesh though the graphics card is wanted, a part of a sentence; null where it does not.
        /// </summary>
        public string Obstacle { get; }

        /// <summary>Number of vertices that took as long to copy as this took to make.</summary>
        public int VerticesBuilt => template.VertexCount / m_Shown.SharedBy;

        /// <summary>
        /// Returns true where the filter still shows the living mesh (a script may have given it another), made of the current content of
        /// the authored mesh with the insect's number of patches, and as the insect wants it deformed.
        /// </summary>
        public bool IsCurrent(InsectWings insect) =>
            insect.Patches == m_Patches && insect.Quality.motionVectors == m_Moves && insect.Quality.levelOfDetail == m_HasLevels
            && insect.Quality.skinning == m_Skinning
            && !template.IsOutdated && filter != null && renderer != null && ReferenceEquals(filter.sharedMesh, m_Mesh)
            && m_Shown.IsCurrent;

        /// <summary>Has the mesh drawn with fewer triangles, where that costs less, or with all.</summary>
        public void ShowSmaller(bool smaller) => m_Shown.ShowSmaller(smaller);

        /// <summary>Uploads the pose of all wings.</summary>
        public void Upload(WingWorld world) => m_Shown.Upload(world);

        /// <summary>Takes away the motion of the last upload: the wings stay as they are.</summary>
        public void Stop(WingWorld world) => m_Shown.Stop(world);

        /// <summary>Gives the filter its authored mesh back, unless a script gave it another, and frees what was shown.</summary>
        public void Restore()
        {
            if (filter != null && IsOfThisWing(filter.sharedMesh))
                filter.sharedMesh = template.Source;
            if (m_Moves && renderer != null)
                renderer.motionVectorGenerationMode = m_Mode;
            foreach (LiveWing wing in wings)
                wing.ForgetAuthored();
            LivingMeshes.Remove(m_Mesh, filter);
            m_Shown.Restore();
        }

        // MeshFilter.mesh makes a duplicate and shows that instead: a frozen, bent wing that must not be taken for an authored one.
        private bool IsOfThisWing(Mesh shown) =>
            ReferenceEquals(shown, m_Mesh) || (shown != null && shown.name.StartsWith(m_Mesh.name, StringComparison.Ordinal));
    }
}
