using System;
using Alate.Geometry;
using UnityEngine;

namespace Alate.Authoring
{
    /// <summary>Makes the mesh of a traced wing for the user.</summary>
    internal static class TracedSurface
    {
        /// <summary>Makes the triangles in the plane y = 0, facing up, with the picture's texture coordinates.</summary>
        public static SurfaceMesh Make(TriangleLinks mesh, WingPlacement placement)
        {
            var normals = new Vector3[mesh.points.Length];
            Array.Fill(normals, Vector3.up);
            return new SurfaceMesh
            {
                positions = Array.ConvertAll(mesh.points, placement.ToMesh),
                normals = normals,
                uvs = Array.ConvertAll(mesh.points, placement.ToTexture),
                triangles = mesh.Clockwise(),
            };
        }
    }
}
