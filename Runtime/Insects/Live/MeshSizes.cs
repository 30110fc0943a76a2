using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate
{
    /// <summary>All triangles of a living mesh and the fewer for where it looks small: ranges of its one index buffer.</summary>
    internal sealed class MeshSizes
    {
        // Renderers are told: some keep what they know of the ranges.
        private const MeshUpdateFlags k_Flags =
            MeshUpdateFlags.DontRecalculateBounds | MeshUpdateFlags.DontValidateIndices | MeshUpdateFlags.DontResetBoneBounds;

        private readonly SubMeshDescriptor[] m_Whole, m_Smaller;

        /// <param name="mesh">The living mesh, whose index buffer ends with the fewer triangles; its bounds are not kept.</param>
        /// <param name="smaller">[submesh] Those.</param>
        public MeshSizes(Mesh mesh, int[][] smaller)
        {
            m_Whole = new SubMeshDescriptor[smaller.Length];
            m_Smaller = new SubMeshDescriptor[smaller.Length];
            int end = 0;
            for (int part = 0; part < smaller.Length; part++)
            {
                m_Whole[part] = mesh.GetSubMesh(part);
                end += m_Whole[part].indexCount;
            }

            // Reading them back has the range of their vertices.
            for (int part = 0; part < smaller.Length; part++)
            {
                mesh.SetSubMesh(part, new SubMeshDescriptor(end, smaller[part].Length, m_Whole[part].topology));
                m_Smaller[part] = mesh.GetSubMesh(part);
                end += smaller[part].Length;
            }

            Show(mesh, false);
        }

        /// <summary>Has a mesh, or a copy of it, drawn with all triangles or with the fewer.</summary>
        public void Show(Mesh mesh, bool smaller)
        {
            SubMeshDescriptor[] parts = smaller ? m_Smaller : m_Whole;
            for (int part = 0; part < parts.Length; part++)
                mesh.SetSubMesh(part, parts[part], k_Flags);
        }

        /// <summary>Triangles of a mesh of which some wings have smaller parts.</summary>
        /// <param name="source">A readable mesh.</param>
        /// <param name="wings">Wings on it.</param>
        /// <returns>[submesh] Vertices of the mesh; null where no wing has a smaller part.</returns>
        public static int[][] FewerOf(Mesh source, RiggedPart[] wings)
        {
            var replaced = new HashSet<int>();
            foreach (RiggedPart wing in wings)
            {
                if (wing.Smaller != null)
                    replaced.UnionWith(wing.Selection.vertices);
            }

            if (replaced.Count == 0)
                return null;
            int[][] parts = new int[source.subMeshCount][];
            for (int part = 0; part < parts.Length; part++)
            {
                // A triangle has either all its corners in such a wing, or none.
                var corners = new List<int>();
                foreach (int vertex in source.GetIndices(part))
                {
                    if (!replaced.Contains(vertex))
                        corners.Add(vertex);
                }

                foreach (RiggedPart wing in wings)
                {
                    if (wing.Smaller != null)
                        corners.AddRange(wing.Smaller.triangles[part]);
                }

                parts[part] = corners.ToArray();
            }

            return parts;
        }
    }
}
