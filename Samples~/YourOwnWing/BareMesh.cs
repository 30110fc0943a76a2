using System.Collections.Generic;
using UnityEngine;

namespace Alate.Samples
{
    /// <summary>
    /// Mesh as a modeller might hand it over: one mesh of a body and two wings, without bones, skeleton or marks of its parts. The wings
    /// are plain grids that taper to the tip.
    /// </summary>
    internal static class BareMesh
    {
        private const int k_SpanCells = 24, k_ChordCells = 12;
        private const float k_Length = 1f, k_Chord = 0.55f, k_Gap = 0.07f;

        private static readonly Color32 s_WingColour = new Color32(190, 214, 226, 255), s_BodyColour = new Color32(92, 84, 78, 255);
        private static readonly Vector3 s_BodySize = new Vector3(0.12f, 0.12f, 0.8f);

        /// <summary>One wing in the space of the whole mesh.</summary>
        public static SurfaceMesh Wing(WingSide side)
        {
            var positions = new List<Vector3>();
            for (int s = 0; s <= k_SpanCells; s++)
            {
                float span = (float)s / k_SpanCells, chord = k_Chord * (1f - 0.75f * span * span * span);
                for (int c = 0; c <= k_ChordCells; c++)
                    positions.Add(new Vector3(k_Gap + k_Length * span, 0.05f, 0.2f - chord * c / k_ChordCells));
            }

            var triangles = new List<int>();
            for (int s = 0; s < k_SpanCells; s++)
            {
                for (int c = 0; c < k_ChordCells; c++)
                {
                    int a = s * (k_ChordCells + 1) + c, b = a + k_ChordCells + 1;
                    triangles.AddRange(new[] { a, b, a + 1, b, b + 1, a + 1 });
                }
            }

            var right = new SurfaceMesh
            {
                name = "Wing",
                positions = positions.ToArray(),
                normals = positions.ConvertAll(_ => Vector3.up).ToArray(),
                colours = positions.ConvertAll(_ => s_WingColour).ToArray(),
                triangles = triangles.ToArray(),
            };
            return side == WingSide.Right ? right : right.Mirrored();
        }

        /// <summary>Body and both wings.</summary>
        public static Mesh Create()
        {
            var positions = new List<Vector3>();
            var normals = new List<Vector3>();
            var colours = new List<Color32>();
            var triangles = new List<int>();
            foreach (SurfaceMesh piece in new[] { Body(), Wing(WingSide.Left), Wing(WingSide.Right) })
            {
                foreach (int corner in piece.triangles)
                    triangles.Add(corner + positions.Count);
                positions.AddRange(piece.positions);
                normals.AddRange(piece.normals);
                colours.AddRange(piece.colours);
            }

            return new SurfaceMesh
            {
                positions = positions.ToArray(),
                normals = normals.ToArray(),
                colours = colours.ToArray(),
                triangles = triangles.ToArray(),
            }.ToMesh("Bare mesh");
        }

        // An octahedron, each of whose sides has corners of its own.
        private static SurfaceMesh Body()
        {
            var positions = new List<Vector3>();
            var normals = new List<Vector3>();
            foreach (float x in new[] { -0.5f, 0.5f })
            {
                foreach (float y in new[] { -0.5f, 0.5f })
                {
                    foreach (float z in new[] { -0.5f, 0.5f })
                        AddSide(positions, normals, Vector3.Scale(new Vector3(x, y, z), s_BodySize));
                }
            }

            int[] triangles = new int[positions.Count];
            for (int k = 0; k < triangles.Length; k++)
                triangles[k] = k;
            return new SurfaceMesh
            {
                positions = positions.ToArray(),
                normals = normals.ToArray(),
                colours = positions.ConvertAll(_ => s_BodyColour).ToArray(),
                triangles = triangles,
            };
        }

        private static void AddSide(List<Vector3> positions, List<Vector3> normals, Vector3 corner)
        {
            Vector3 a = new Vector3(corner.x, 0f, 0f), b = new Vector3(0f, corner.y, 0f), c = new Vector3(0f, 0f, corner.z);
            Vector3 normal = Vector3.Cross(b - a, c - a).normalized;
            bool isOutward = Vector3.Dot(normal, corner) > 0f;
            positions.AddRange(isOutward ? new[] { a, b, c } : new[] { a, c, b });
            for (int k = 0; k < 3; k++)
                normals.Add(isOutward ? normal : -normal);
        }
    }
}
