using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Tests
{
    /// <summary>The closed pieces of a mesh, and what lies inside them.</summary>
    internal static class BodyPieces
    {
        /// <summary>Finds, for each piece, the first corners of its triangles.</summary>
        public static List<List<int>> Of(SurfaceMesh mesh)
        {
            int[] parents = new int[mesh.VertexCount];
            for (int vertex = 0; vertex < parents.Length; vertex++)
            {
                parents[vertex] = vertex;
            }

            for (int corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                parents[Root(parents, mesh.triangles[corner])] = Root(parents, mesh.triangles[corner + 1]);
                parents[Root(parents, mesh.triangles[corner + 1])] = Root(parents, mesh.triangles[corner + 2]);
            }

            var pieces = new Dictionary<int, List<int>>();
            for (int corner = 0; corner < mesh.triangles.Length; corner += 3)
            {
                int root = Root(parents, mesh.triangles[corner]);
                if (!pieces.TryGetValue(root, out List<int> piece))
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
            foreach (int corner in piece)
            {
                for (int k = 0; k < 3; k++)
                {
                    bounds.Encapsulate(mesh.positions[mesh.triangles[corner + k]]);
                }
            }

            return bounds;
        }

        public static double Volume(SurfaceMesh mesh, List<int> piece)
        {
            double volume = 0.0;
            Vector3 origin = mesh.positions[mesh.triangles[piece[0]]];
            foreach (int corner in piece)
            {
                Vector3 a = mesh.positions[mesh.triangles[corner]] - origin;
                volume += Vector3.Dot(a, AreaVector(mesh, corner)) / 3;
            }

            return volume;
        }

        /// <summary>The normal of a triangle, as long as its area.</summary>
        public static Vector3 AreaVector(SurfaceMesh mesh, int corner)
        {
            Vector3 origin = mesh.positions[mesh.triangles[corner]];
            return 0.5f * Vector3.Cross(
                mesh.positions[mesh.triangles[corner + 1]] - origin, mesh.positions[mesh.triangles[corner + 2]] - origin);
        }

        /// <summary>Winding number of a piece about a point: 1 inside, 0 outside (van Oosterom and Strackee's solid angles).</summary>
        public static double Winding(SurfaceMesh mesh, List<int> piece, Vector3 point)
        {
            double angle = 0.0;
            foreach (int corner in piece)
            {
                Vector3 a = mesh.positions[mesh.triangles[corner]] - point;
                Vector3 b = mesh.positions[mesh.triangles[corner + 1]] - point;
                Vector3 c = mesh.positions[mesh.triangles[corner + 2]] - point;
                double la = a.magnitude, lb = b.magnitude, lc = c.magnitude;
                float triple = Vector3.Dot(a, Vector3.Cross(b, c));
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
