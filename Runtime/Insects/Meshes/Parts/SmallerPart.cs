using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Part of a mesh with a sixth of its triangles, of some of its vertices, for where it looks small.</summary>
    internal sealed class SmallerPart
    {
        /// <summary>One triangle remains of so many.</summary>
        private const int k_Share = 6;

        /// <summary>Number of triangles that remain at least.</summary>
        private const int k_Least = 64;

        /// <summary>Number of triangles of the largest part that is made smaller: it takes a tenth of a second.</summary>
        private const int k_Most = 8000;

        /// <summary>All vertices of the part, those of the smaller one first, each kind ascending; and all its triangles.</summary>
        public readonly MeshSelection selection;

        /// <summary>Number of vertices of the smaller part.</summary>
        public readonly int vertexCount;

        /// <summary>[submesh] Three vertices of the mesh a triangle of the smaller part.</summary>
        public readonly int[][] triangles;

        private SmallerPart(MeshSelection selection, int vertexCount, int[][] triangles)
        {
            this.selection = selection;
            this.vertexCount = vertexCount;
            this.triangles = triangles;
        }

        /// <summary>
        /// Takes vertices out of a part, the least missed first; margins and seams keep their places (see <see cref="TriangleReducer"/>).
        /// </summary>
        /// <param name="mesh">A readable mesh.</param>
        /// <param name="selection">Part of it.</param>
        /// <returns>Null where it has few triangles or very many, or others of the mesh hang on to its vertices.</returns>
        public static SmallerPart Of(Mesh mesh, MeshSelection selection)
        {
            int count = selection.triangles.Length / 3, wanted = Math.Max(count / k_Share, k_Least);
            int[][] whole = wanted < count && count <= k_Most ? Triangles(mesh, selection) : null;
            if (whole == null)
                return null;
            Vector3[] positions = mesh.vertices;
            var reducer = new TriangleReducer(
                Array.ConvertAll(selection.vertices, vertex => (float3)positions[vertex]),
                Array.ConvertAll(whole, part => Array.ConvertAll(part, vertex => Array.BinarySearch(selection.vertices, vertex))));
            reducer.ReduceTo(wanted);
            int[][] kept = reducer.Parts();
            bool[] stays = new bool[selection.vertices.Length];
            foreach (int[] part in kept)
            {
                foreach (int place in part)
                    stays[place] = true;
            }

            int[] order = Order(stays, out int vertexCount);
            return new SmallerPart(
                Reordered(selection, order), vertexCount,
                Array.ConvertAll(kept, part => Array.ConvertAll(part, place => selection.vertices[place])));
        }

        // [submesh] The triangles of the part; null where one of the mesh has corners in the part and beyond.
        private static int[][] Triangles(Mesh mesh, MeshSelection selection)
        {
            var own = new HashSet<int>(selection.vertices);
            int[][] parts = new int[mesh.subMeshCount][];
            for (int part = 0; part < parts.Length; part++)
            {
                int[] indices = mesh.GetIndices(part);
                if (mesh.GetTopology(part) != MeshTopology.Triangles)
                {
                    if (own.Overlaps(indices))
                        return null;
                    parts[part] = Array.Empty<int>();
                    continue;
                }

                var corners = new List<int>();
                for (int k = 0; k < indices.Length; k += 3)
                {
                    bool first = own.Contains(indices[k]);
                    if (own.Contains(indices[k + 1]) != first || own.Contains(indices[k + 2]) != first)
                        return null;
                    if (first)
                        corners.AddRange(new[] { indices[k], indices[k + 1], indices[k + 2] });
                }

                parts[part] = corners.ToArray();
            }

            return parts;
        }

        // [new place] Place in the selection.
        private static int[] Order(bool[] stays, out int count)
        {
            int[] order = new int[stays.Length];
            count = 0;
            for (int place = 0; place < stays.Length; place++)
            {
                if (stays[place])
                    order[count++] = place;
            }

            int next = count;
            for (int place = 0; place < stays.Length; place++)
            {
                if (!stays[place])
                    order[next++] = place;
            }

            return order;
        }

        private static MeshSelection Reordered(MeshSelection selection, int[] order)
        {
            int[] places = new int[order.Length];
            for (int place = 0; place < order.Length; place++)
                places[order[place]] = place;
            return new MeshSelection(
                Array.ConvertAll(order, place => selection.vertices[place]),
                Array.ConvertAll(selection.triangles, corner => places[corner]));
        }
    }
}
