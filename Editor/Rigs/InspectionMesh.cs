using System;
using System.Collections.Generic;
using Unity.Mathematics;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Mesh drawn over a wing to show the effect of its rig: every triangle on its own, coloured. Never saved; dispose it.
    /// </summary>
    internal sealed class InspectionMesh : IDisposable
    {
        private RigInspection m_Shown;

        /// <summary>The mesh, in the space of the wing's own; null before <see cref="Show"/>.</summary>
        public Mesh Mesh { get; private set; }

        /// <summary>Shows a wing in colours.</summary>
        /// <inheritdoc cref="RigColouring.Corners"/>
        public void Show(RigInspection rig, RigColourMode mode, IReadOnlyCollection<JointIndex> joints, in WingParameters parameters)
        {
            if (Mesh == null)
                Mesh = new Mesh { name = "Rig Inspection", hideFlags = HideFlags.HideAndDontSave };
            if (m_Shown != rig)
                Fill(rig);
            m_Shown = rig;
            Mesh.colors32 = RigColouring.Corners(rig, mode, joints, parameters);
        }

        /// <summary>Frees the mesh.</summary>
        public void Dispose()
        {
            if (Mesh != null)
                Object.DestroyImmediate(Mesh);
            Mesh = null;
            m_Shown = null;
        }

        private void Fill(RigInspection rig)
        {
            var positions = new Vector3[3 * rig.triangles.Count];
            int[] indices = new int[positions.Length];
            for (int corner = 0; corner < positions.Length; corner++)
            {
                int3 triangle = rig.triangles.corners[corner / 3];
                positions[corner] = rig.Surface.positions[triangle[corner % 3]];
                indices[corner] = corner;
            }

            Mesh.Clear();
            Mesh.indexFormat = positions.Length > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16;
            Mesh.vertices = positions;
            Mesh.SetTriangles(indices, 0);
        }
    }
}
