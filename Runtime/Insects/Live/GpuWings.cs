using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Wings that the graphics card deforms: their joints go into the texture that all insects share. Near and far ones keep one mesh, so
    /// that they are drawn together.
    /// </summary>
    internal sealed class GpuWings : ShownWings
    {
        private static readonly int s_Start = Shader.PropertyToID("_SkinStart"), s_Tint = Shader.PropertyToID("_SkinTint");
        private static readonly List<Material> s_Shown = new List<Material>();

        private readonly MeshTemplate m_Template;
        private readonly Renderer m_Renderer;
        private readonly GpuSkins m_Skins;
        private readonly Material[] m_Sources, m_Copies;
        private readonly int m_Start;
        private readonly bool m_Moves;
        private readonly List<bool> m_HadProperties = new List<bool>();

        private GpuWings(MeshTemplate template, Renderer renderer, GpuSkins skins, int start, bool moves)
        {
            m_Template = template;
            m_Renderer = renderer;
            m_Skins = skins;
            m_Start = start;
            m_Moves = moves;
            m_Sources = System.Array.ConvertAll(renderer.sharedMaterials, SkinMaterials.SourceOf);
            m_Copies = System.Array.ConvertAll(m_Sources, skins.Materials.Acquire);
            renderer.sharedMaterials = m_Copies;
            TellStart();
        }

        public override Mesh Mesh => m_Template.Skinned;

        // Measured; what remains is the state of the wings.
        public override int SharedBy => 4;

        public override VertexPacking Packing => VertexPacking.Joints;

        public override bool Moves => false;

        public override bool IsCurrent
        {
            get
            {
                m_Renderer.GetSharedMaterials(s_Shown);
                bool same = s_Shown.Count == m_Copies.Length;
                for (int k = 0; same && k < m_Copies.Length; k++)
                    same = ReferenceEquals(s_Shown[k], m_Copies[k]);
                s_Shown.Clear();
                return same;
            }
        }

        /// <summary>Gives the wings of a renderer to the graphics card.</summary>
        /// <param name="template">Source and wings.</param>
        /// <param name="renderer">What draws them.</param>
        /// <param name="skins">Texture and materials.</param>
        /// <param name="moves">Whether motion vectors are wanted.</param>
        /// <param name="obstacle">Why it cannot be, a part of a sentence that names the object; null otherwise.</param>
        /// <returns>Null where it cannot be.</returns>
        public static GpuWings TryMake(MeshTemplate template, Renderer renderer, GpuSkins skins, bool moves, out string obstacle)
        {
            obstacle = GpuSkins.FindObstacle(renderer);
            if (obstacle != null)
                return null;
            if (skins.Table.TryTake(template.JointCount, moves, out int start))
                return new GpuWings(template, renderer, skins, start, moves);
            obstacle = $"the texture of joints is full with {skins.Table.Joints} of them; {template.JointCount} more are wanted";
            return null;
        }

        public override int FirstJoint(int wing) => m_Start + m_Template.FirstJoints[wing];

        public override void Upload(WingWorld world)
        {
            if (m_Renderer == null)
                return;

            // A script may have set properties of its own in place of all.
            m_Renderer.GetPropertyBlock(m_Skins.Properties);
            if (!IsTold)
            {
                m_HadProperties[0] = true;
                Tell(-1);
            }

            m_Skins.Table.MarkWritten();
            if (m_Skins.Table.Last == 0)
                return;
            for (int w = 0; w < Wings.Length; w++)
            {
                if (!world.IsMovedOn(Wings[w].handle))
                    m_Skins.Table.ForgetPast(FirstJoint(w), Wings[w].rig.JointCount);
                world.TakePicture(Wings[w].handle);
            }
        }

        // The texture keeps the past of all wings.
        public override void Stop(WingWorld world)
        {
        }

        public override void Restore()
        {
            if (m_Renderer != null)
            {
                Material[] shown = m_Renderer.sharedMaterials;
                for (int k = 0; k < shown.Length; k++)
                {
                    if (k < m_Copies.Length && ReferenceEquals(shown[k], m_Copies[k]))
                        shown[k] = m_Sources[k];
                    else if (shown[k] != null && shown[k].IsKeywordEnabled(SkinMaterials.Keyword))
                        shown[k].DisableKeyword(SkinMaterials.Keyword);
                }

                m_Renderer.sharedMaterials = shown;
                ForgetStart(shown.Length);
            }

            foreach (Material copy in m_Copies)
                m_Skins.Materials.Return(copy);
            m_Skins.Table.Return(m_Start, m_Template.JointCount, m_Moves);
        }

        // Properties of a material's own hide those of the renderer.
        private void TellStart()
        {
            for (int k = -1; k < m_Copies.Length; k++)
            {
                Read(k);
                m_HadProperties.Add(!m_Skins.Properties.isEmpty);
                if (k < 0 || !m_Skins.Properties.isEmpty)
                    Tell(k);
            }
        }

        private bool IsTold => m_Skins.Properties.HasFloat(s_Start) && m_Skins.Properties.GetFloat(s_Start) == m_Start
            && m_Skins.Properties.HasColor(s_Tint);

        private void Tell(int material)
        {
            m_Skins.Properties.SetFloat(s_Start, m_Start);
            if (!m_Skins.Properties.HasColor(s_Tint))
                m_Skins.Properties.SetColor(s_Tint, Color.white);
            Write(m_Skins.Properties, material);
        }

        private void ForgetStart(int materials)
        {
            for (int k = -1; k < m_Copies.Length && k < materials; k++)
            {
                if (!m_HadProperties[k + 1])
                    Write(null, k);
            }
        }

        private void Read(int material)
        {
            if (material < 0)
                m_Renderer.GetPropertyBlock(m_Skins.Properties);
            else
                m_Renderer.GetPropertyBlock(m_Skins.Properties, material);
        }

        private void Write(MaterialPropertyBlock properties, int material)
        {
            if (material < 0)
                m_Renderer.SetPropertyBlock(properties);
            else
                m_Renderer.SetPropertyBlock(properties, material);
        }
    }
}
