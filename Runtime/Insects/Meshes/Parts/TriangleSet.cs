using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace Alate
{
    /// <summary>Some of the triangles of a mesh, by submesh.</summary>
    internal sealed class TriangleSet
    {
        private readonly Mesh m_Mesh;
        private readonly int[][] m_Corners;
        private readonly bool[][] m_Has;

        /// <summary>Makes an empty set for a readable mesh.</summary>
        public TriangleSet(Mesh mesh)
        {
            m_Mesh = mesh;
            m_Corners = new int[mesh.subMeshCount][];
            m_Has = new bool[mesh.subMeshCount][];
            for (int submesh = 0; submesh < m_Corners.Length; submesh++)
            {
                m_Corners[submesh] = mesh.GetTopology(submesh) == MeshTopology.Triangles ? mesh.GetTriangles(submesh) : Array.Empty<int>();
                m_Has[submesh] = new bool[m_Corners[submesh].Length / 3];
            }
        }

        /// <summary>True where the set has no triangle.</summary>
        public bool IsEmpty => Array.TrueForAll(m_Has, has => Array.IndexOf(has, true) < 0);

        /// <summary>True where the set has all triangles of the mesh.</summary>
        public bool IsAll => Array.TrueForAll(m_Has, has => Array.IndexOf(has, false) < 0);

        /// <summary>Corners of the set's triangles, three each.</summary>
        public int[] Corners() => Divide((a, b, c) => 0).Values.SelectMany(group => group).SelectMany(own => own).ToArray();

        /// <summary>Returns true where the set has a triangle of a submesh.</summary>
        public bool Has(int submesh, int triangle) => m_Has[submesh][triangle];

        /// <summary>Adds the triangles for which a condition on submesh and corners holds.</summary>
        public void Add(Func<int, int, int, int, bool> fits)
        {
            for (int submesh = 0; submesh < m_Corners.Length; submesh++)
            {
                int[] corners = m_Corners[submesh];
                for (int triangle = 0; triangle < m_Has[submesh].Length; triangle++)
                {
                    int first = 3 * triangle;
                    m_Has[submesh][triangle] |= fits(submesh, corners[first], corners[first + 1], corners[first + 2]);
                }
            }
        }

        /// <summary>Adds a part of the mesh.</summary>
        /// <exception cref="ArgumentException">As <see cref="MeshParts.Select"/>.</exception>
        public void Add(WingPart part, int submesh, Vector3 point)
        {
            int[] vertices = MeshParts.Select(m_Mesh, part, submesh, point).vertices;
            Add((own, a, b, c) => part == WingPart.Submesh ? own == submesh : Array.BinarySearch(vertices, a) >= 0);
        }

        /// <summary>Groups the corners of the set's triangles by a key, and by submesh within a group.</summary>
        public Dictionary<TKey, int[][]> Divide<TKey>(Func<int, int, int, TKey> groupOf)
        {
            var lists = new Dictionary<TKey, List<int>[]>();
            for (int submesh = 0; submesh < m_Corners.Length; submesh++)
            {
                int[] corners = m_Corners[submesh];
                for (int first = 0; first < corners.Length; first += 3)
                {
                    if (!m_Has[submesh][first / 3])
                        continue;
                    TKey group = groupOf(corners[first], corners[first + 1], corners[first + 2]);
                    if (!lists.TryGetValue(group, out List<int>[] own))
                        lists.Add(group, own = Array.ConvertAll(m_Corners, _ => new List<int>()));
                    own[submesh].AddRange(new[] { corners[first], corners[first + 1], corners[first + 2] });
                }
            }

            var groups = new Dictionary<TKey, int[][]>();
            foreach (KeyValuePair<TKey, List<int>[]> pair in lists)
                groups.Add(pair.Key, Array.ConvertAll(pair.Value, own => own.ToArray()));
            return groups;
        }
    }
}
