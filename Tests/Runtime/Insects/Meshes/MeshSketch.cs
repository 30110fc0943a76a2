using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate.Tests
{
    /// <summary>Meshes for tests, put together from sheets, boxes and tubes; each submesh is a list of triangles.</summary>
    public sealed class MeshSketch
    {
        public readonly List<Vector3> positions = new List<Vector3>();
        private readonly List<List<int>> m_Submeshes = new List<List<int>> { new List<int>() };

        /// <summary>Begins the next submesh.</summary>
        public MeshSketch NextSubmesh()
        {
            m_Submeshes.Add(new List<int>());
            return this;
        }

        /// <summary>A parallelogram of columns × rows quads, two triangles each.</summary>
        public MeshSketch Sheet(Vector3 corner, Vector3 span, Vector3 chord, int columns = 6, int rows = 4)
        {
            int first = positions.Count;
            for (int c = 0; c <= columns; c++)
            {
                for (int r = 0; r <= rows; r++)
                    positions.Add(corner + span * ((float)c / columns) + chord * ((float)r / rows));
            }

            for (int c = 0; c < columns; c++)
            {
                for (int r = 0; r < rows; r++)
                {
                    int a = first + c * (rows + 1) + r;
                    Quad(a, a + rows + 1, a + rows + 2, a + 1);
                }
            }

            return this;
        }

        /// <summary>A flat wing that tapers: base at <paramref name="hinge"/>, span along ±X, chord backwards.</summary>
        public MeshSketch Wing(Vector3 hinge, float span, float chord, int columns = 6, int rows = 4)
        {
            int first = positions.Count;
            Sheet(hinge, new Vector3(span, 0f, 0f), new Vector3(0f, 0f, -chord), columns, rows);
            for (int vertex = first; vertex < positions.Count; vertex++)
            {
                Vector3 p = positions[vertex] - hinge;
                p.z *= 1f - 0.6f * Mathf.Pow(p.x / span, 2f);
                positions[vertex] = hinge + p;
            }

            return this;
        }

        /// <summary>A closed box of 12 triangles with 8 vertices.</summary>
        public MeshSketch Box(Vector3 centre, Vector3 size)
        {
            int first = positions.Count;
            for (int corner = 0; corner < 8; corner++)
            {
                var sign = new Vector3((corner & 1) - 0.5f, (corner >> 1 & 1) - 0.5f, (corner >> 2 & 1) - 0.5f);
                positions.Add(centre + Vector3.Scale(sign, size));
            }

            Quad(first, first + 2, first + 3, first + 1);
            Quad(first + 4, first + 5, first + 7, first + 6);
            Quad(first, first + 1, first + 5, first + 4);
            Quad(first + 2, first + 6, first + 7, first + 3);
            Quad(first, first + 4, first + 6, first + 2);
            Quad(first + 1, first + 3, first + 7, first + 5);
            return this;
        }

        /// <summary>Adds a vertex that no triangle uses.</summary>
        public MeshSketch Stray(Vector3 position)
        {
            positions.Add(position);
            return this;
        }

        /// <summary>Gives each triangle three vertices of its own.</summary>
        public MeshSketch Split()
        {
            Vector3[] old = positions.ToArray();
            positions.Clear();
            foreach (List<int> submesh in m_Submeshes)
            {
                for (int corner = 0; corner < submesh.Count; corner++)
                {
                    positions.Add(old[submesh[corner]]);
                    submesh[corner] = positions.Count - 1;
                }
            }

            return this;
        }

        /// <summary>A readable mesh with normals; the caller destroys it.</summary>
        public Mesh ToMesh(string name = "Sketch")
        {
            var mesh = new Mesh { name = name, indexFormat = positions.Count > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16 };
            mesh.SetVertices(positions);
            mesh.subMeshCount = m_Submeshes.Count;
            for (int submesh = 0; submesh < m_Submeshes.Count; submesh++)
                mesh.SetTriangles(m_Submeshes[submesh], submesh);
            mesh.RecalculateNormals();
            mesh.RecalculateBounds();
            return mesh;
        }

        private void Quad(int a, int b, int c, int d)
        {
            List<int> triangles = m_Submeshes[m_Submeshes.Count - 1];
            triangles.AddRange(new[] { a, b, c, a, c, d });
        }
    }
}
