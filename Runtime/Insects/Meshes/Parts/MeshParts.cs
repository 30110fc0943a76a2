using System;
using System.Collections.Generic;
using Alate.Geometry;
using Unity.Mathematics;
using UnityEngine;

namespace Alate
{
    /// <summary>Takes a wing out of a mesh: all of it, a submesh, or a connected part.</summary>
    internal static class MeshParts
    {
        /// <summary>Selects the part of a mesh that is a wing.</summary>
        /// <param name="mesh">A readable mesh.</param>
        /// <param name="part">What of it is the wing.</param>
        /// <param name="submesh">From 0; only for <see cref="WingPart.Submesh"/>.</param>
        /// <param name="point">Mesh space; only for <see cref="WingPart.ConnectedPart"/>.</param>
        /// <exception cref="ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="ArgumentException">It is not readable, has no such submesh, or the part has no triangles; or the point is not
        /// finite.</exception>
        public static MeshSelection Select(Mesh mesh, WingPart part, int submesh, Vector3 point)
        {
            SurfaceMesh.CheckReadable(mesh);
            switch (part)
            {
                case WingPart.WholeMesh:
                    return MeshSelection.Of(AllCorners(mesh));
                case WingPart.Submesh:
                    return MeshSelection.Of(Corners(mesh, submesh));
                case WingPart.ConnectedPart:
                    return Connected(mesh, point);
                default:
                    throw new ArgumentException($"{part} is not a part of a mesh.");
            }
        }

        /// <summary>Surface of a part to bake: its own vertices, in the selection's numbering.</summary>
        /// <exception cref="ArgumentException">The mesh is not readable.</exception>
        public static SurfaceMesh Surface(Mesh mesh, MeshSelection selection)
        {
            SurfaceMesh.CheckReadable(mesh);
            return new SurfaceMesh
            {
                name = mesh.name,
                positions = Pick(mesh.vertices, selection.vertices),
                normals = Pick(mesh.normals, selection.vertices),
                tangents = Pick(mesh.tangents, selection.vertices),
                triangles = selection.triangles,
            };
        }

        /// <summary>
        /// All pieces of a mesh that hang together, in the order of their first vertices, each with a point that tells it from the others,
        /// mesh space.
        /// </summary>
        /// <exception cref="ArgumentException">The mesh is not readable or has no triangles.</exception>
        public static List<(MeshSelection selection, Vector3 point)> Parts(Mesh mesh)
        {
            SurfaceMesh.CheckReadable(mesh);
            int[] corners = AllCorners(mesh);
            Vector3[] positions = mesh.vertices;
            DisjointSets sets = Connect(corners, positions);
            var ofSet = new SortedDictionary<int, List<int>>();
            for (int corner = 0; corner < corners.Length; corner++)
            {
                int set = sets.Find(corners[corner]);
                if (!ofSet.TryGetValue(set, out List<int> own))
                    ofSet.Add(set, own = new List<int>());
                own.Add(corners[corner]);
            }

            var pieces = new List<(MeshSelection selection, Vector3 point)>(ofSet.Count);
            foreach (List<int> own in ofSet.Values)
                pieces.Add((MeshSelection.Of(own.ToArray()), MiddleOfLargest(own, positions)));
            return pieces;
        }

        private static Vector3 MiddleOfLargest(List<int> corners, Vector3[] positions)
        {
            Vector3 middle = default;
            float largest = -1f;
            for (int corner = 0; corner < corners.Count; corner += 3)
            {
                Vector3 a = positions[corners[corner]], b = positions[corners[corner + 1]], c = positions[corners[corner + 2]];
                float size = Vector3.Cross(b - a, c - a).magnitude;
                if (size > largest)
                {
                    largest = size;
                    middle = (a + b + c) / 3f;
                }
            }

            return middle;
        }

        private static MeshSelection Connected(Mesh mesh, Vector3 point)
        {
            if (!math.all(math.isfinite((float3)point)))
                throw new ArgumentException($"The point {point} on mesh '{mesh.name}' is not finite.");
            int[] corners = AllCorners(mesh);
            Vector3[] positions = mesh.vertices;
            DisjointSets sets = Connect(corners, positions);
            int wanted = sets.Find(corners[Nearest(corners, positions, point)]);
            return MeshSelection.Of(Array.FindAll(corners, vertex => sets.Find(vertex) == wanted));
        }

        /// <summary>Joins the vertices of the triangles into sets where triangles share a vertex or touch.</summary>
        public static DisjointSets Connect(int[] corners, Vector3[] positions)
        {
            var sets = new DisjointSets(positions.Length);
            for (int corner = 0; corner < corners.Length; corner += 3)
            {
                sets.Join(corners[corner], corners[corner + 1]);
                sets.Join(corners[corner], corners[corner + 2]);
            }

            VertexWeld.Join(positions, MeshSelection.Of(corners).vertices, sets);
            return sets;
        }

        /// <summary>Finds the first corner of the triangle nearest to the point.</summary>
        private static int Nearest(int[] corners, Vector3[] positions, Vector3 point)
        {
            int nearest = 0;
            float least = float.PositiveInfinity;
            for (int corner = 0; corner < corners.Length; corner += 3)
            {
                float square = TriangleDistance.Square(
                    point, positions[corners[corner]], positions[corners[corner + 1]], positions[corners[corner + 2]]);
                if (square < least)
                {
                    least = square;
                    nearest = corner;
                }
            }

            return nearest;
        }

        private static int[] AllCorners(Mesh mesh)
        {
            int[] corners = SurfaceMesh.Triangles(mesh);
            if (corners.Length == 0)
                throw new ArgumentException($"Mesh '{mesh.name}' has no triangles.");
            return corners;
        }

        private static int[] Corners(Mesh mesh, int submesh)
        {
            if (submesh < 0 || submesh >= mesh.subMeshCount)
                throw new ArgumentException($"Mesh '{mesh.name}' has no submesh {submesh}: it has {mesh.subMeshCount}, numbered from 0.");
            if (mesh.GetTopology(submesh) != MeshTopology.Triangles)
            {
                throw new ArgumentException(
                    $"Submesh {submesh} of mesh '{mesh.name}' consists of {mesh.GetTopology(submesh)}; a wing needs Triangles.");
            }

            int[] corners = mesh.GetTriangles(submesh);
            if (corners.Length == 0)
                throw new ArgumentException($"Submesh {submesh} of mesh '{mesh.name}' has no triangles.");
            return corners;
        }

        private static T[] Pick<T>(T[] all, int[] places) =>
            all.Length == 0 ? Array.Empty<T>() : Array.ConvertAll(places, place => all[place]);
    }
}
