using Alate.Catalogue;
using UnityEngine;

namespace Alate.Tests.Play
{
    /// <summary>Meshes for insects of tests.</summary>
    internal static class Specimens
    {
        /// <summary>A wing of a species.</summary>
        public static Mesh Mesh(WingDefinition kind, WingSide side, float unitsPerMetre)
        {
            return kind.CreateSurface(side, unitsPerMetre).ToMesh(kind.Name + " " + side);
        }

        /// <summary>
        /// A mesh that no wing can be made of: "empty", "lines", "needle", "point", "not a number", "endless" or "huge", which is also its
        /// name.
        /// </summary>
        public static UnityEngine.Mesh NoWing(string kind)
        {
            var mesh = new UnityEngine.Mesh { name = kind };
            Vector3[] corners = { Vector3.zero, Vector3.right, Vector3.forward };
            switch (kind)
            {
                case "lines":
                    mesh.vertices = corners;
                    mesh.SetIndices(new[] { 0, 1, 1, 2 }, MeshTopology.Lines, 0);
                    break;
                case "needle":
                    mesh.vertices = new[] { Vector3.zero, Vector3.right, 2f * Vector3.right };
                    mesh.triangles = new[] { 0, 1, 2 };
                    break;
                case "point":
                    mesh.vertices = new Vector3[3];
                    mesh.triangles = new[] { 0, 1, 2 };
                    break;
                case "not a number":
                    corners[1].y = float.NaN;
                    mesh.vertices = corners;
                    mesh.triangles = new[] { 0, 1, 2 };
                    break;
                case "endless":
                    corners[1].x = float.PositiveInfinity;
                    mesh.vertices = corners;
                    mesh.triangles = new[] { 0, 1, 2 };
                    break;
                case "huge":
                    mesh.vertices = System.Array.ConvertAll(corners, corner => 1e30f * corner);
                    mesh.triangles = new[] { 0, 1, 2 };
                    break;
            }

            return mesh;
        }
    }
}
