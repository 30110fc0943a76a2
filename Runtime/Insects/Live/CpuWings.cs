using Unity.Collections;
using UnityEngine;

namespace Alate
{
    /// <summary>Wings whose vertices are computed here and uploaded to a mesh of their own.</summary>
    internal sealed class CpuWings : ShownWings
    {
        private readonly MeshTemplate m_Template;
        private readonly Mesh m_Copy;
        private readonly int m_DisplacementStream;
        private bool m_Moving;

        public CpuWings(MeshTemplate template, Renderer renderer, bool moves)
        {
            m_Template = template;
            Moves = moves && DeformableMesh.CanMove;
            Packing = !template.IsPacked ? VertexPacking.None
                : MaterialTangents.AreRead(renderer) ? VertexPacking.NormalsAndTangents : VertexPacking.Normals;
            m_Copy = template.CreateCopy(Moves);
            m_DisplacementStream = Moves ? m_Copy.GetVertexAttributeStream(DeformableMesh.DisplacementAttribute) : 0;
        }

        public override Mesh Mesh => m_Copy;

        public override int SharedBy => 1;

        public override VertexPacking Packing { get; }

        public override bool Moves { get; }

        public override bool IsCurrent => true;

        public override void Upload(WingWorld world)
        {
            if (m_Copy == null)
                return;
            foreach (LiveWing wing in Wings)
            {
                if (m_Template.IsPacked)
                {
                    Upload(world.PackedVertices(wing.handle), wing.start, DeformableMesh.VertexStream);
                    Upload(world.PackedTangents(wing.handle), wing.start, DeformableMesh.TangentStream);
                }
                else
                {
                    Upload(world.Vertices(wing.handle), wing.start, DeformableMesh.VertexStream);
                    Upload(world.Tangents(wing.handle), wing.start, DeformableMesh.TangentStream);
                }

                if (Moves)
                {
                    Upload(world.Displacements(wing.handle), wing.start, m_DisplacementStream);
                    world.TakePicture(wing.handle);
                    m_Moving = true;
                }
            }
        }

        public override void Stop(WingWorld world)
        {
            if (!m_Moving || m_Copy == null)
                return;
            m_Moving = false;
            foreach (LiveWing wing in Wings)
            {
                world.StopDisplacements(wing.handle);
                Upload(world.Displacements(wing.handle), wing.start, m_DisplacementStream);
            }
        }

        public override void Restore() => ObjectEnd.Destroy(m_Copy);

        private void Upload<T>(NativeArray<T> values, int start, int stream) where T : struct
        {
            if (values.IsCreated)
                m_Copy.SetVertexBufferData(values, 0, start, values.Length, stream, DeformableMesh.UploadFlags);
        }
    }
}
