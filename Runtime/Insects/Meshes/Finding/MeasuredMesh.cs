using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// Shapes of a mesh and of its parts, in the insect's space; of a mesh that cannot be read, estimates from its boxes.
    /// </summary>
    internal sealed class MeasuredMesh
    {
        // Area over that of the largest sheet from which a piece can be a wing of its own, not a vein or a speck.
        private const float k_SmallestPiece = 0.1f;

        private const int k_Several = -1;

        private readonly Mesh m_Mesh;
        private readonly Matrix4x4 m_ToInsect;
        private readonly Vector3[] m_Positions;
        private int[] m_Owners;

        public MeasuredMesh(Mesh mesh, Matrix4x4 toInsect)
        {
            m_Mesh = mesh;
            m_ToInsect = toInsect;
            m_Positions = mesh.isReadable ? mesh.vertices : null;
        }

        /// <summary>True where the triangles can be read.</summary>
        public bool IsReadable => m_Positions != null;

        /// <summary>Number of submeshes.</summary>
        public int SubmeshCount => m_Mesh.subMeshCount;

        /// <summary>Returns true where a submesh has triangles.</summary>
        public bool IsDrawn(int submesh) =>
            m_Mesh.GetTopology(submesh) == MeshTopology.Triangles && m_Mesh.GetSubMesh(submesh).indexCount > 0;

        /// <summary>Shape of the whole mesh, which must have triangles.</summary>
        public WingShape Whole() => IsReadable ? Shape(WingPart.WholeMesh, 0) : WingShape.Of(m_Mesh.bounds, m_ToInsect);

        /// <summary>Shape of one submesh, which must have triangles.</summary>
        public WingShape Submesh(int submesh) =>
            IsReadable ? Shape(WingPart.Submesh, submesh) : WingShape.Of(m_Mesh.GetSubMesh(submesh).bounds, m_ToInsect);

        /// <summary>
        /// The larger connected parts of a readable mesh that are sheets on one side: shape, a point in mesh space, and submesh, −1 where
        /// it reaches over several.
        /// </summary>
        public List<(WingShape shape, Vector3 point, int submesh)> Sheets()
        {
            var sheets = new List<(WingShape shape, Vector3 point, int submesh)>();
            float largest = 0f;
            foreach ((MeshSelection selection, Vector3 point) piece in MeshParts.Parts(m_Mesh))
            {
                var shape = WingShape.Of(m_Positions, piece.selection, m_ToInsect);
                if (!shape.isSheet || shape.Side == null)
                    continue;
                sheets.Add((shape, piece.point, SubmeshOf(piece.selection)));
                largest = Mathf.Max(largest, shape.area);
            }

            sheets.RemoveAll(piece => piece.shape.area < k_SmallestPiece * largest);
            return sheets;
        }

        /// <summary>Halves of a box towards its right and left face, for meshes that cannot be read.</summary>
        /// <param name="submesh">−1 for the box around all.</param>
        public List<(WingShape shape, Vector3 point, int submesh)> Halves(int submesh)
        {
            Bounds box = submesh == k_Several ? m_Mesh.bounds : m_Mesh.GetSubMesh(submesh).bounds;
            var across = (Vector3)m_ToInsect.GetRow(0);
            int axis = 0;
            for (int other = 1; other < 3; other++)
                axis = Mathf.Abs(across[other] * box.extents[other]) > Mathf.Abs(across[axis] * box.extents[axis]) ? other : axis;

            Vector3 step = Vector3.zero;
            step[axis] = box.extents[axis];
            Vector3 size = box.size - step;
            return new List<(WingShape shape, Vector3 point, int submesh)>
            {
                (WingShape.Of(new Bounds(box.center + 0.5f * step, size), m_ToInsect), box.center + step, submesh),
                (WingShape.Of(new Bounds(box.center - 0.5f * step, size), m_ToInsect), box.center - step, submesh),
            };
        }

        private WingShape Shape(WingPart part, int submesh) =>
            WingShape.Of(m_Positions, MeshParts.Select(m_Mesh, part, submesh, Vector3.zero), m_ToInsect);

        private int SubmeshOf(MeshSelection piece)
        {
            if (SubmeshCount == 1)
                return 0;
            m_Owners ??= Owners();
            int first = m_Owners[piece.vertices[0]];
            return System.Array.TrueForAll(piece.vertices, vertex => m_Owners[vertex] == first) ? first : k_Several;
        }

        // The submesh that each vertex belongs to.
        private int[] Owners()
        {
            const int k_None = -2;
            int[] owners = new int[m_Positions.Length];
            System.Array.Fill(owners, k_None);
            for (int submesh = 0; submesh < SubmeshCount; submesh++)
            {
                if (!IsDrawn(submesh))
                    continue;
                foreach (int vertex in m_Mesh.GetTriangles(submesh))
                    owners[vertex] = owners[vertex] == k_None || owners[vertex] == submesh ? submesh : k_Several;
            }

            return owners;
        }
    }
}
