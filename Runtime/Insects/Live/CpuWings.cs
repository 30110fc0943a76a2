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
        private bool m_Moving, m_Smaller;

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

        public override void ShowSmaller(bool smaller)
        {
            m_Smaller = smaller;
            if (m_Copy != null)
                m_Template.Sizes?.Show(m_Copy, smaller);
        }

        public override void Upload(WingWorld world)
        {
            if (m_Copy == null)
                return;
            for (int w = 0; w < Wings.Length; w++)
            {
                LiveWing wing = Wings[w];
                if (m_Template.IsPacked)
                {
                    Upload(world.PackedVertices(wing.handle), w, DeformableMesh.VertexStream);
                    Upload(world.PackedTangents(wing.handle), w, DeformableMesh.TangentStream);
                }
                else
                {
                    Upload(world.Vertices(wing.handle), w, DeformableMesh.VertexStream);
                    Upload(world.Tangents(wing.handle), w, DeformableMesh.TangentStream);
                }

                if (Moves)
                {
                    Upload(world.Displacements(wing.handle), w, m_DisplacementStream);
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
            for (int w = 0; w < Wings.Length; w++)
            {
                world.StopDisplacements(Wings[w].handle);
                Upload(world.Displacements(Wings[w].handle), w, m_DisplacementStream);
            }
        }

        public override void Restore() => ObjectEnd.Destroy(m_Copy);

        // Those of the smaller part are the first.
        private void Upload<T>(NativeArray<T> values, int wing, int stream) where T : struct
        {
            if (!values.IsCreated)
                return;
            int count = m_Smaller && m_Template.Shapes[wing].Smaller is { } smaller ? smaller.vertexCount : values.Length;
            m_Copy.SetVertexBufferData(values, 0, Wings[wing].start, count, stream, DeformableMesh.UploadFlags);
        }
    }
}
