using System;
using Unity.Collections;
using UnityEngine;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>
    /// Copy of a wing's mesh in a pose, drawn in the place of the authored one, which is neither changed nor saved otherwise. Dispose it.
    /// </summary>
    internal sealed class PosedMesh : IDisposable
    {
        private readonly MeshRenderer m_Renderer;
        private readonly Vector3[] m_Positions, m_Normals;
        private readonly bool m_WasOff;

        /// <param name="renderer">Draws the authored mesh.</param>
        /// <param name="source">That mesh; readable.</param>
        /// <param name="wings">Their places in the insect's list.</param>
        /// <param name="parts">[wing of the mesh] Vertices and rig; taken over.</param>
        public PosedMesh(MeshRenderer renderer, Mesh source, int[] wings, RiggedPart[] parts)
        {
            m_Renderer = renderer;
            Wings = wings;
            Parts = parts;
            m_Positions = source.vertices;
            m_Normals = source.normals;
            Mesh = Object.Instantiate(source);
            Mesh.name = source.name + " (preview)";
            Mesh.hideFlags = HideFlags.HideAndDontSave;
            m_WasOff = renderer.forceRenderingOff;
            renderer.forceRenderingOff = true;
        }

        /// <summary>The posed copy.</summary>
        public Mesh Mesh { get; }

        /// <summary>[wing of the mesh] Place in the insect's list.</summary>
        public int[] Wings { get; }

        /// <summary>[wing of the mesh] Vertices and rig.</summary>
        public RiggedPart[] Parts { get; }

        /// <summary>Takes over the vertices of a wing.</summary>
        public void Take(int part, NativeArray<SkinnedVertex> vertices)
        {
            int[] places = Parts[part].Selection.vertices;
            for (int k = 0; k < places.Length; k++)
            {
                m_Positions[places[k]] = vertices[k].position;
                if (m_Normals.Length > 0)
                    m_Normals[places[k]] = vertices[k].normal;
            }
        }

        /// <summary>Writes what was taken over to the mesh.</summary>
        public void Apply()
        {
            Mesh.vertices = m_Positions;
            if (m_Normals.Length > 0)
                Mesh.normals = m_Normals;
            Mesh.RecalculateBounds();
        }

        /// <summary>Draws for a camera.</summary>
        public void Draw(Camera camera)
        {
            if (m_Renderer == null || !m_Renderer.enabled || !m_Renderer.gameObject.activeInHierarchy)
                return;
            Material[] materials = m_Renderer.sharedMaterials;
            for (int submesh = 0; submesh < Mathf.Min(materials.Length, Mesh.subMeshCount); submesh++)
            {
                if (materials[submesh] == null)
                    continue;
                var drawn = new RenderParams(materials[submesh])
                {
                    camera = camera,
                    layer = m_Renderer.gameObject.layer,
                    renderingLayerMask = m_Renderer.renderingLayerMask,
                    shadowCastingMode = m_Renderer.shadowCastingMode,
                    receiveShadows = m_Renderer.receiveShadows,
                };
                Graphics.RenderMesh(drawn, Mesh, submesh, m_Renderer.localToWorldMatrix);
            }
        }

        public void Dispose()
        {
            foreach (RiggedPart part in Parts)
                part.Rig.Release();
            if (m_Renderer != null)
                m_Renderer.forceRenderingOff = m_WasOff;
            Object.DestroyImmediate(Mesh);
        }
    }
}
