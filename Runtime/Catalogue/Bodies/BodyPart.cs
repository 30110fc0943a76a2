using System;
using System.Collections.Generic;
using UnityEngine;

namespace Alate.Catalogue
{
    /// <summary>
    /// One closed piece of a body, millimetres: triangles that face outwards, smooth normals, and texture coordinates from 0 to 1 of the
    /// piece itself, u around it (0 on its upper line, 1 on its lower one, the same on both sides, so that no seam is needed) and v along
    /// it.
    /// </summary>
    internal sealed class BodyPart
    {
        private BodyPart(SurfaceMesh surface, Vector2 extent)
        {
            Surface = surface;
            Extent = extent;
        }

        /// <summary>Triangles of the piece.</summary>
        public SurfaceMesh Surface { get; }

        public Vector3[] Positions => Surface.positions;

        public Vector3[] Normals => Surface.normals;

        public Vector2[] Uvs => Surface.uvs;

        public int[] Triangles => Surface.triangles;

        /// <summary>Width and length of the unrolled piece: half its girth and its length, millimetres.</summary>
        public Vector2 Extent { get; }

        /// <summary>Makes a piece from its triangles, with smooth normals; turns the winding where the volume comes out negative.</summary>
        public static BodyPart Of(Vector3[] positions, Vector2[] uvs, int[] triangles, Vector2 extent)
        {
            int[] outward = Volume(positions, triangles) >= 0 ? triangles : SurfaceMesh.Turned(triangles);
            var surface =
                new SurfaceMesh { positions = positions, normals = SmoothNormals(positions, outward), uvs = uvs, triangles = outward };
            return new BodyPart(surface, extent);
        }

        /// <summary>The mirror image in the plane x = 0, with the same texture coordinates.</summary>
        public BodyPart Mirrored() => new BodyPart(Surface.Mirrored(), Extent);

        /// <summary>Piece with its points moved; normals follow.</summary>
        public BodyPart Moved(Func<Vector3, Vector3> move) => Of(Array.ConvertAll(Positions, place => move(place)), Uvs, Triangles, Extent);

        private static double Volume(Vector3[] positions, int[] triangles)
        {
            double volume = 0.0;
            Vector3 origin = positions.Length == 0 ? default : positions[0];
            for (int corner = 0; corner < triangles.Length; corner += 3)
            {
                Vector3 a = positions[triangles[corner]] - origin;
                Vector3 b = positions[triangles[corner + 1]] - origin;
                volume += Vector3.Dot(a, Vector3.Cross(b, positions[triangles[corner + 2]] - origin));
            }

            return volume / 6;
        }

        private static Vector3[] SmoothNormals(Vector3[] positions, IReadOnlyList<int> triangles)
        {
            var normals = new Vector3[positions.Length];
            for (int corner = 0; corner < triangles.Count; corner += 3)
            {
                Vector3 origin = positions[triangles[corner]];
                var doubledArea = Vector3.Cross(positions[triangles[corner + 1]] - origin, positions[triangles[corner + 2]] - origin);
                for (int c = corner; c < corner + 3; c++)
                    normals[triangles[c]] += doubledArea;
            }

            // Not Vector3.normalized, which gives up on vectors as short as those of the smallest triangles.
            return Array.ConvertAll(normals, normal => normal / normal.magnitude);
        }
    }
}
