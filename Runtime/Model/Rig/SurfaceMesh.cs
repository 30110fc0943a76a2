using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Triangle mesh as plain arrays, one entry per vertex: the output of the generators, before or without a <see cref="Mesh"/>. Triangles
    /// are three indices each, wound so that (x1 − x0) × (x2 − x0) is the outward or upper side.
    /// </summary>
    [MovedFrom(true, null, "Alate")]
    public sealed class SurfaceMesh
    {
        /// <summary>Positions, in the unit given to the generator.</summary>
        public Vector3[] positions;

        /// <summary>Unit normals.</summary>
        public Vector3[] normals;

        /// <summary>Texture coordinates from 0 to 1; null when there are none.</summary>
        public Vector2[] uvs;

        /// <summary>Vertex colours; null when there are none.</summary>
        public Color32[] colours;

        /// <summary>Vertex indices, three per triangle.</summary>
        public int[] triangles;

        /// <summary>Number of vertices.</summary>
        public int VertexCount => positions.Length;

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => triangles.Length / 3;

        /// <summary>The mirror image in the plane x = 0: a left wing from a right one. The winding turns with it, so that up stays up.</summary>
        public SurfaceMesh Mirrored()
        {
            var turned = new int[triangles.Length];
            for (var corner = 0; corner < turned.Length; corner += 3)
            {
                turned[corner] = triangles[corner];
                turned[corner + 1] = triangles[corner + 2];
                turned[corner + 2] = triangles[corner + 1];
            }

            return new SurfaceMesh
            {
                positions = Array.ConvertAll(positions, MirrorX),
                normals = Array.ConvertAll(normals, MirrorX),
                uvs = (Vector2[])uvs?.Clone(),
                colours = (Color32[])colours?.Clone(),
                triangles = turned,
            };
        }

        /// <summary>Surface over these arrays, not copied, from which a rig is baked.</summary>
        public WingSurface ToWingSurface(string name) =>
            new WingSurface { name = name, positions = positions, normals = normals, triangles = triangles };

        /// <summary>A readable mesh of the same content, with its bounds set.</summary>
        public Mesh ToMesh(string name)
        {
            var mesh = new Mesh
            {
                name = name,
                indexFormat = VertexCount > ushort.MaxValue ? IndexFormat.UInt32 : IndexFormat.UInt16,
                vertices = positions,
                normals = normals,
            };

            if (uvs != null)
                mesh.uv = uvs;

            if (colours != null)
                mesh.colors32 = colours;

            mesh.triangles = triangles;
            mesh.RecalculateBounds();
            return mesh;
        }

        private static Vector3 MirrorX(Vector3 vector) => new Vector3(-vector.x, vector.y, vector.z);
    }
}
