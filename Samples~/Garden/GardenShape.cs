using System.Collections.Generic;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>A mesh of the garden while it is made: quadrangles and triangles with a colour at each corner.</summary>
    internal sealed class GardenShape
    {
        private readonly List<Vector3> m_Positions = new List<Vector3>();
        private readonly List<Color32> m_Colours = new List<Color32>();
        private readonly List<int> m_Triangles = new List<int>();

        /// <summary>Position of a corner.</summary>
        public Vector3 this[int corner] => m_Positions[corner];

        /// <summary>Adds a corner.</summary>
        /// <returns>Its index.</returns>
        public int Add(Vector3 position, Color colour)
        {
            m_Positions.Add(position);
            colour.a = Mathf.Clamp01(colour.a);
            m_Colours.Add(colour);
            return m_Positions.Count - 1;
        }

        /// <summary>Adds a triangle whose upper side is the one from which its corners go round clockwise.</summary>
        public void Triangle(int a, int b, int c) => m_Triangles.AddRange(new[] { a, b, c });

        /// <summary>Joins two rows of as many corners, from left to right, the second one ahead of the first.</summary>
        /// <param name="first">Index of the first corner of the row.</param>
        /// <param name="next">The same of the row ahead.</param>
        /// <param name="count">Corners of a row.</param>
        public void Join(int first, int next, int count)
        {
            for (int k = 0; k + 1 < count; k++)
            {
                Triangle(first + k, next + k, next + k + 1);
                Triangle(first + k, next + k + 1, first + k + 1);
            }
        }

        /// <summary>Adds a ring of corners around a vertical axis, closed by a corner in the place of the first one.</summary>
        /// <param name="centre">Of the ring.</param>
        /// <param name="radius">World units.</param>
        /// <param name="corners">Number of corners.</param>
        /// <param name="colour">Of all corners.</param>
        /// <returns>Index of the first of them; there is one more.</returns>
        public int Ring(Vector3 centre, float radius, int corners, Color colour)
        {
            int first = m_Positions.Count;
            for (int k = 0; k <= corners; k++)
                Add(centre + Quaternion.Euler(0f, 360f / corners * k, 0f) * new Vector3(0f, 0f, radius), colour);
            return first;
        }

        /// <summary>The mesh; its normals are computed.</summary>
        public Mesh ToMesh(string name)
        {
            var mesh = new SurfaceMesh
            {
                positions = m_Positions.ToArray(),
                colours = m_Colours.ToArray(),
                triangles = m_Triangles.ToArray(),
            }.ToMesh(name);
            mesh.RecalculateNormals();
            return mesh;
        }
    }
}
