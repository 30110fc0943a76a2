using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>
    /// Triangle mesh as plain arrays: what rigs are baked from and skeletons are laid out on, and the output of the generators. Triangles
    /// are wound so that (x1 − x0) × (x2 − x0) is the outward or upper side.
    /// </summary>
    /// <remarks>
    /// A wing is a single sheet, a double-sided one (each triangle twice, with or without vertices of its own) or a thin closed shell. Two
    /// sheets one above the other that are open at the rim count as twice the area.
    /// </remarks>
    [MovedFrom(true, null, "Alate")]
    public sealed class SurfaceMesh
    {
        /// <summary>Name in messages; may be null.</summary>
        public string name;

        /// <summary>[vertex] Positions, mesh units.</summary>
        public Vector3[] positions;

        /// <summary>[vertex] Unit normals; null or empty to compute them.</summary>
        public Vector3[] normals;

        /// <summary>[vertex] Tangents; null or empty for none.</summary>
        public Vector4[] tangents;

        /// <summary>[vertex] Texture coordinates from 0 to 1; null when there are none.</summary>
        public Vector2[] uvs;

        /// <summary>[vertex] Colours; null when there are none.</summary>
        public Color32[] colours;

        /// <summary>Vertex indices, three per triangle.</summary>
        public int[] triangles;

        /// <summary>Number of vertices.</summary>
        public int VertexCount => positions.Length;

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => triangles.Length / 3;

        /// <summary>Positions, normals, tangents and the triangles of all submeshes of a mesh.</summary>
        /// <exception cref="ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="ArgumentException">The mesh is not readable.</exception>
        public static SurfaceMesh FromMesh(Mesh mesh)
        {
            CheckReadable(mesh);
            return new SurfaceMesh
            {
                name = mesh.name,
                positions = mesh.vertices,
                normals = mesh.normals,
                tangents = mesh.tangents,
                triangles = Triangles(mesh),
            };
        }

        /// <summary>
        /// Mirror image in the plane x = 0: a left wing from a right one. The winding turns with it, so that up stays up.
        /// </summary>
        public SurfaceMesh Mirrored() => new SurfaceMesh
        {
            name = name,
            positions = Array.ConvertAll(positions, MirrorX),
            normals = normals == null ? null : Array.ConvertAll(normals, MirrorX),
            tangents = tangents == null
                ? null
                : Array.ConvertAll(tangents, tangent => new Vector4(-tangent.x, tangent.y, tangent.z, -tangent.w)),
            uvs = (Vector2[])uvs?.Clone(),
            colours = (Color32[])colours?.Clone(),
            triangles = Turned(triangles),
        };

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

            if (tangents != null)
                mesh.tangents = tangents;
            if (uvs != null)
                mesh.uv = uvs;
            if (colours != null)
                mesh.colors32 = colours;
            mesh.triangles = triangles;
            mesh.RecalculateBounds();
            return mesh;
        }

        /// <summary>Corners of the triangles of all submeshes.</summary>
        internal static int[] Triangles(Mesh mesh)
        {
            var corners = new List<int>();
            for (int s = 0; s < mesh.subMeshCount; s++)
            {
                if (mesh.GetTopology(s) == MeshTopology.Triangles)
                    corners.AddRange(mesh.GetTriangles(s));
            }

            return corners.ToArray();
        }

        /// <summary>Copy of the corners of triangles, wound the other way round.</summary>
        internal static int[] Turned(int[] triangles)
        {
            int[] turned = (int[])triangles.Clone();
            for (int corner = 0; corner < turned.Length; corner += 3)
                (turned[corner + 1], turned[corner + 2]) = (triangles[corner + 2], triangles[corner + 1]);
            return turned;
        }

        /// <summary>Refuses a mesh whose triangles cannot be read.</summary>
        internal static void CheckReadable(Mesh mesh)
        {
            if (mesh == null)
                throw new ArgumentNullException(nameof(mesh));
            if (!mesh.isReadable)
                throw new ArgumentException($"Mesh '{mesh.name}' is not readable: turn on Read/Write in its import settings.");
        }

        private static Vector3 MirrorX(Vector3 vector) => new Vector3(-vector.x, vector.y, vector.z);
    }
}
