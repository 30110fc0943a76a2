using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// Flat tufts of scales on a part: dots whose edges stay sharp however coarse the skin below is. All share one disc of the texture.
    /// </summary>
    internal static class Tufts
    {
        /// <summary>Corners of a tuft, and vertices: its top, then its corners, then its root.</summary>
        private const int k_Sides = 6, k_Vertices = k_Sides + 2;

        /// <summary>Height of a tuft over the skin, depth of its rim below it and of its root, as shares of its radius.</summary>
        private const float k_Rise = 0.24f, k_Rim = 0.2f, k_Root = 0.4f;

        /// <summary>Weight of the skin's normal in those of a tuft's top and rim, so that it is lit as the skin.</summary>
        private const float k_Top = 2f, k_Edge = 0.45f;

        /// <summary>The tufts of the right side of a part, each at the vertex that is nearest to a place.</summary>
        /// <param name="skin">The part.</param>
        /// <param name="places">Millimetres.</param>
        /// <param name="radius">Millimetres.</param>
        public static BodyPart On(BodyPart skin, IReadOnlyList<Vector3> places, float radius)
        {
            var positions = new List<Vector3>();
            var uvs = new List<Vector2>();
            var skinNormals = new List<Vector3>();
            var triangles = new List<int>();
            var middle = new Vector2(0.5f, 0.5f);
            foreach (Vector3 place in places)
            {
                int vertex = Nearest(skin, place), first = positions.Count;
                Vector3 root = skin.Positions[vertex], up = skin.Normals[vertex];
                var right = Vector3.Cross(up, new Vector3(0f, 1f, 0.3f));
                right /= right.magnitude;
                var ahead = Vector3.Cross(right, up);
                positions.Add(root + k_Rise * radius * up);
                uvs.Add(middle);
                for (int side = 0; side < k_Sides; side++)
                {
                    double angle = 2 * Math.PI * side / k_Sides;
                    var corner = new Vector2((float)Math.Cos(angle), (float)Math.Sin(angle));
                    positions.Add(root + radius * (corner.x * right + corner.y * ahead - k_Rim * up));
                    uvs.Add(middle + 0.5f * corner);
                    int one = first + 1 + side, next = first + 1 + (side + 1) % k_Sides;
                    triangles.AddRange(new[] { first, one, next, first + k_Vertices - 1, next, one });
                }

                positions.Add(root - k_Root * radius * up);
                uvs.Add(middle);
                for (int k = 0; k < k_Vertices; k++)
                    skinNormals.Add((k == 0 ? k_Top : k == k_Vertices - 1 ? 0f : k_Edge) * up);
            }

            var part = BodyPart.Of(positions.ToArray(), uvs.ToArray(), triangles.ToArray(), 2f * radius * Vector2.one);
            for (int k = 0; k < skinNormals.Count; k++)
            {
                Vector3 mixed = part.Normals[k] + skinNormals[k];
                part.Normals[k] = mixed / mixed.magnitude;
            }

            return part;
        }

        private static int Nearest(BodyPart skin, Vector3 place)
        {
            int nearest = 0;
            for (int vertex = 1; vertex < skin.Positions.Length; vertex++)
            {
                if ((skin.Positions[vertex] - place).sqrMagnitude < (skin.Positions[nearest] - place).sqrMagnitude)
                    nearest = vertex;
            }

            return nearest;
        }
    }
}
