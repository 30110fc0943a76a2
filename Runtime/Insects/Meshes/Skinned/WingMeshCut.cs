using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Alate
{
    /// <summary>Makes meshes of some of the triangles of another.</summary>
    internal static class WingMeshCut
    {
        private const int k_Channels = 8;

        /// <summary>
        /// A mesh of these triangles alone, moved by a matrix; colours and texture coordinates are kept, weights are not.
        /// </summary>
        /// <param name="mesh">The mesh they are taken from; it is not changed.</param>
        /// <param name="shape">Its vertices.</param>
        /// <param name="submeshes">Corners of the triangles by submesh of the new mesh.</param>
        /// <param name="matrix">To the space of the new mesh. If it mirrors, triangles are turned to face the same way.</param>
        public static Mesh Cut(Mesh mesh, BlendedShape shape, IReadOnlyList<int[]> submeshes, Matrix4x4 matrix)
        {
            var selection = MeshSelection.Of(submeshes);
            int[] vertices = selection.vertices;
            Matrix4x4 turn = matrix.inverse.transpose;
            float hand = matrix.determinant < 0f ? -1f : 1f;

            var taken = new Mesh { indexFormat = vertices.Length > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16 };
            taken.vertices = Array.ConvertAll(vertices, vertex => matrix.MultiplyPoint3x4(shape.positions[vertex]));
            if (shape.normals.Length > 0)
                taken.normals = Array.ConvertAll(vertices, vertex => turn.MultiplyVector(shape.normals[vertex]).normalized);
            if (shape.tangents.Length > 0)
                taken.tangents = Array.ConvertAll(vertices, vertex => Tangent(shape.tangents[vertex], matrix, hand));
            CopyColours(mesh, taken, vertices);
            for (int channel = 0; channel < k_Channels; channel++)
                CopyCoordinates(mesh, taken, vertices, channel);

            taken.subMeshCount = submeshes.Count;
            int start = 0;
            for (int submesh = 0; submesh < submeshes.Count; submesh++)
            {
                int[] own = new int[submeshes[submesh].Length];
                Array.Copy(selection.triangles, start, own, 0, own.Length);
                start += own.Length;
                taken.SetTriangles(hand < 0f ? SurfaceMesh.Turned(own) : own, submesh, false);
            }

            taken.RecalculateBounds();
            return taken;
        }

        /// <summary>
        /// A copy of a mesh without some triangles: with all its vertices, weights and blend shapes, and as many submeshes.
        /// </summary>
        /// <param name="mesh">It is not changed.</param>
        /// <param name="isTaken">Whether a triangle of a submesh is left out.</param>
        public static Mesh Without(Mesh mesh, Func<int, int, bool> isTaken)
        {
            Mesh rest = UnityEngine.Object.Instantiate(mesh);

            // Submeshes with base vertices may have more vertices than their indices count to.
            if (mesh.vertexCount > ushort.MaxValue)
                rest.indexFormat = IndexFormat.UInt32;
            rest.subMeshCount = mesh.subMeshCount;
            for (int submesh = 0; submesh < mesh.subMeshCount; submesh++)
            {
                int[] corners = mesh.GetIndices(submesh);
                if (mesh.GetTopology(submesh) != MeshTopology.Triangles)
                {
                    rest.SetIndices(corners, mesh.GetTopology(submesh), submesh, false);
                    continue;
                }

                var left = new List<int>(corners.Length);
                for (int corner = 0; corner < corners.Length; corner++)
                {
                    if (!isTaken(submesh, corner / 3))
                        left.Add(corners[corner]);
                }

                rest.SetTriangles(left.ToArray(), submesh, false);
            }

            rest.bounds = mesh.bounds;
            return rest;
        }

        private static Vector4 Tangent(Vector4 tangent, Matrix4x4 matrix, float hand)
        {
            Vector4 moved = matrix.MultiplyVector(tangent).normalized;
            moved.w = tangent.w * hand;
            return moved;
        }

        private static void CopyColours(Mesh from, Mesh to, int[] vertices)
        {
            if (!from.HasVertexAttribute(VertexAttribute.Color))
                return;
            if (from.GetVertexAttributeFormat(VertexAttribute.Color) == VertexAttributeFormat.UNorm8)
                to.colors32 = Pick(from.colors32, vertices);
            else
                to.colors = Pick(from.colors, vertices);
        }

        private static void CopyCoordinates(Mesh from, Mesh to, int[] vertices, int channel)
        {
            VertexAttribute attribute = VertexAttribute.TexCoord0 + channel;
            if (!from.HasVertexAttribute(attribute))
                return;
            var all = new List<Vector4>();
            from.GetUVs(channel, all);
            Vector4[] picked = Array.ConvertAll(vertices, vertex => all[vertex]);
            switch (from.GetVertexAttributeDimension(attribute))
            {
                case 4:
                    to.SetUVs(channel, picked);
                    break;
                case 3:
                    to.SetUVs(channel, Array.ConvertAll(picked, one => (Vector3)one));
                    break;
                default:
                    to.SetUVs(channel, Array.ConvertAll(picked, one => (Vector2)one));
                    break;
            }
        }

        private static T[] Pick<T>(T[] all, int[] vertices) => Array.ConvertAll(vertices, vertex => all[vertex]);
    }
}
