using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>The closed pieces of a mesh, and what lies inside them.</summary>
    internal static class BodyPieces
    {
        /// <summary>For each piece the first corners of its triangles.</summary>
        public static List<List<int>> Of(SurfaceMesh mesh)
        {
            var parents = new int[mesh.VertexCount];
            for (var vertex = 0; vertex < parents.Length; vertex++)
            {
                parents[vertex] = vertex;
            }

            for (var corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                parents[Root(parents, mesh.triangles[corner])] = Root(parents, mesh.triangles[corner + 1]);
                parents[Root(parents, mesh.triangles[corner + 1])] = Root(parents, mesh.triangles[corner + 2]);
            }

            var pieces = new Dictionary<int, List<int>>();
            for (var corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                var root = Root(parents, mesh.triangles[corner]);
                if (!pieces.TryGetValue(root, out var piece))
                {
                    pieces.Add(root, piece = new List<int>());
                }

                piece.Add(corner);
            }

            return new List<List<int>>(pieces.Values);
        }

        public static Bounds BoundsOf(SurfaceMesh mesh, List<int> piece)
        {
            var bounds = new Bounds(mesh.positions[mesh.triangles[piece[0]]], Vector3.zero);
            foreach (var corner in piece)
            {
                for (var k = 0; k < 3; k++)
                {
                    bounds.Encapsulate(mesh.positions[mesh.triangles[corner + k]]);
                }
            }

            return bounds;
        }

        public static double Volume(SurfaceMesh mesh, List<int> piece)
        {
            var volume = 0.0;
            var origin = mesh.positions[mesh.triangles[piece[0]]];
            foreach (var corner in piece)
            {
                var a = mesh.positions[mesh.triangles[corner]] - origin;
                volume += Vector3.Dot(a, AreaVector(mesh, corner)) / 3;
            }

            return volume;
        }

        /// <summary>The normal of a triangle, as long as its area.</summary>
        public static Vector3 AreaVector(SurfaceMesh mesh, int corner)
        {
            var origin = mesh.positions[mesh.triangles[corner]];
            return 0.5f * Vector3.Cross(
                mesh.positions[mesh.triangles[corner + 1]] - origin, mesh.positions[mesh.triangles[corner + 2]] - origin);
        }

        /// <summary>Winding number of a piece about a point: 1 inside, 0 outside (van Oosterom and Strackee's solid angles).</summary>
        public static double Winding(SurfaceMesh mesh, List<int> piece, Vector3 point)
        {
            var angle = 0.0;
            foreach (var corner in piece)
            {
                var a = mesh.positions[mesh.triangles[corner]] - point;
                var b = mesh.positions[mesh.triangles[corner + 1]] - point;
                var c = mesh.positions[mesh.triangles[corner + 2]] - point;
                double la = a.magnitude, lb = b.magnitude, lc = c.magnitude;
                var triple = Vector3.Dot(a, Vector3.Cross(b, c));
                angle += 2 * Math.Atan2(triple, la * lb * lc + Vector3.Dot(a, b) * lc + Vector3.Dot(b, c) * la + Vector3.Dot(c, a) * lb);
            }

            return angle / (4 * Math.PI);
        }

        private static int Root(int[] parents, int vertex)
        {
            while (parents[vertex] != vertex)
            {
                vertex = parents[vertex] = parents[parents[vertex]];
            }

            return vertex;
        }
    }
}
