using System.Collections.Generic;
using UnityEngine;

namespace Alate
{
    /// <summary>
    /// A simple body from ellipsoids and tubes: X to the right, Y up, Z ahead, the origin in the middle of the thorax. It carries the wings in a picture and does
    /// not take part in the model.
    /// </summary>
    public sealed class InsectBody
    {
        readonly IReadOnlyList<TubePart> m_Parts;

        internal InsectBody(IReadOnlyList<TubePart> parts)
        {
            m_Parts = parts;
        }

        /// <summary>The body as one mesh with vertex colours and no texture coordinates.</summary>
        /// <param name="unitsPerMetre">Mesh units of one metre of the real insect.</param>
        public SurfaceMesh CreateSurface(float unitsPerMetre)
        {
            var positions = new List<Vector3>();
            var colours = new List<Color32>();
            var triangles = new List<int>();
            foreach (var part in m_Parts)
            {
                part.AppendTo(positions, colours, triangles);
            }

            var surface = new SurfaceMesh
            {
                positions = positions.ToArray(),
                colours = colours.ToArray(),
                triangles = triangles.ToArray(),
            };
            surface.normals = SmoothNormals(surface.positions, surface.triangles);
            Scale(surface.positions, unitsPerMetre * 1e-3f);
            return surface;
        }

        static void Scale(Vector3[] positions, float factor)
        {
            for (var vertex = 0; vertex < positions.Length; vertex++)
            {
                positions[vertex] *= factor;
            }
        }

        static Vector3[] SmoothNormals(Vector3[] positions, int[] triangles)
        {
            var normals = new Vector3[positions.Length];
            for (var corner = 0; corner < triangles.Length; corner += 3)
            {
                var origin = positions[triangles[corner]];
                var doubledArea = Vector3.Cross(positions[triangles[corner + 1]] - origin, positions[triangles[corner + 2]] - origin);
                for (var c = corner; c < corner + 3; c++)
                {
                    normals[triangles[c]] += doubledArea;
                }
            }

            for (var vertex = 0; vertex < normals.Length; vertex++)
            {
                normals[vertex] = normals[vertex].normalized;
            }

            return normals;
        }
    }
}
