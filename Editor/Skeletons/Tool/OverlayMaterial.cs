using System;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace Alate.Editor
{
    /// <summary>Draws translucent meshes in the scene view, in vertex colours or one colour, from both sides. Dispose it.</summary>
    internal sealed class OverlayMaterial : IDisposable
    {
        private Material m_Material;

        /// <summary>Draws a mesh now; for repaint events.</summary>
        public void Draw(Mesh mesh, Matrix4x4 matrix, Color tint, bool edges = false)
        {
            if (mesh == null || !TryMake())
                return;
            m_Material.SetColor("_Color", tint);
            if (!m_Material.SetPass(0))
                return;
            bool wireframe = GL.wireframe;
            GL.wireframe = edges;
            Graphics.DrawMeshNow(mesh, matrix);
            GL.wireframe = wireframe;
        }

        public void Dispose()
        {
            if (m_Material != null)
                Object.DestroyImmediate(m_Material);
            m_Material = null;
        }

        // A shader that every editor has, whatever the render pipeline.
        private bool TryMake()
        {
            if (m_Material != null)
                return true;
            var shader = Shader.Find("Hidden/Internal-Colored");
            if (shader == null)
                return false;
            m_Material = new Material(shader) { hideFlags = HideFlags.HideAndDontSave };
            m_Material.SetFloat("_SrcBlend", (float)BlendMode.SrcAlpha);
            m_Material.SetFloat("_DstBlend", (float)BlendMode.OneMinusSrcAlpha);
            m_Material.SetFloat("_Cull", (float)CullMode.Off);
            m_Material.SetFloat("_ZWrite", 0f);
            m_Material.SetFloat("_ZTest", (float)CompareFunction.LessEqual);

            // Colours lie in the wing's own surface: a little nearer, so that the two do not flicker.
            m_Material.SetFloat("_ZBias", -1f);
            return true;
        }
    }
}
