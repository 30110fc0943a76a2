using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Scripting.APIUpdating;

namespace Alate
{
    /// <summary>The triangles of a wing as plain arrays, in mesh space.</summary>
    /// <remarks>
    /// A single sheet, a double-sided one (each triangle twice, with or without vertices of its own) or a thin closed shell. Two
    /// sheets one above the other that are open at the rim count as twice the area.
    /// </remarks>
    [MovedFrom(true, null, "Alate")]
    public struct WingSurface
    {
        /// <summary>Name in messages; may be null.</summary>
        public string name;

        /// <summary>Vertex positions.</summary>
        public Vector3[] positions;

        /// <summary>A normal per vertex; null or empty to compute them.</summary>
        public Vector3[] normals;

        /// <summary>A tangent per vertex; null or empty for none.</summary>
        public Vector4[] tangents;

        /// <summary>Three vertex indices a triangle.</summary>
        public int[] triangles;

        /// <summary>The triangles of all submeshes of a mesh.</summary>
        /// <exception cref="System.ArgumentNullException">There is no mesh.</exception>
        /// <exception cref="System.ArgumentException">The mesh is not readable.</exception>
        public static WingSurface FromMesh(Mesh mesh)
        {
            CheckReadable(mesh);
            return new WingSurface
            {
                name = mesh.name,
                positions = mesh.vertices,
                normals = mesh.normals,
                tangents = mesh.tangents,
                triangles = Triangles(mesh),
            };
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

        /// <summary>Refuses a mesh whose triangles cannot be read.</summary>
        internal static void CheckReadable(Mesh mesh)
        {
            if (mesh == null)
                throw new System.ArgumentNullException(nameof(mesh));
            if (!mesh.isReadable)
                throw new System.ArgumentException($"Mesh '{mesh.name}' is not readable: turn on Read/Write in its import settings.");
        }
    }
}
