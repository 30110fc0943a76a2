using System;
using System.Collections.Generic;
using System.Linq;

namespace Alate
{
    /// <summary>Set of triangles of a mesh and the vertices they use.</summary>
    internal sealed class MeshSelection
    {
        /// <summary>Vertices of the mesh, ascending unless said otherwise; each is a corner of one of the triangles.</summary>
        public readonly int[] vertices;

        /// <summary>Corners, three a triangle: places in <see cref="vertices"/>, in the mesh's order and winding.</summary>
        public readonly int[] triangles;

        public MeshSelection(int[] vertices, int[] triangles)
        {
            this.vertices = vertices;
            this.triangles = triangles;
        }

        /// <summary>Selects triangles of several submeshes.</summary>
        /// <param name="submeshes">Corners of the triangles, by submesh.</param>
        public static MeshSelection Of(IEnumerable<int[]> submeshes) => Of(submeshes.SelectMany(own => own).ToArray());

        /// <summary>Selects the vertices that the corners use, and renumbers the corners to them.</summary>
        /// <param name="corners">Three vertices of the mesh a triangle.</param>
        public static MeshSelection Of(int[] corners)
        {
            int[] vertices = (int[])corners.Clone();
            Array.Sort(vertices);
            int count = 0;
            foreach (int vertex in vertices)
            {
                if (count == 0 || vertices[count - 1] != vertex)
                    vertices[count++] = vertex;
            }

            Array.Resize(ref vertices, count);
            return new MeshSelection(vertices, Array.ConvertAll(corners, vertex => Array.BinarySearch(vertices, vertex)));
        }
    }
}
