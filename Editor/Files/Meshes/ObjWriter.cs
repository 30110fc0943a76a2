using System;
using System.IO;
using System.Text;
using UnityEngine;

namespace Alate.Files
{
    /// <summary>
    /// Writes a mesh as a Wavefront OBJ file, coordinates as they are: with v and its colour where there is one, vt where there are texture
    /// coordinates, vn and f.
    /// </summary>
    internal static class ObjWriter
    {
        private const int k_Buffer = 1024;

        /// <param name="mesh">The mesh.</param>
        /// <param name="stream">Where to.</param>
        /// <param name="library">File of the mesh's material; null for none.</param>
        /// <param name="material">Name of that material.</param>
        public static void Write(SurfaceMesh mesh, Stream stream, string library = null, string material = null)
        {
            using var text = new StreamWriter(stream, new UTF8Encoding(false), k_Buffer, true) { NewLine = "\n" };
            if (library != null)
                text.WriteLine($"mtllib {library}\nusemtl {material}");
            for (int k = 0; k < mesh.positions.Length; k++)
            {
                Vector3 p = mesh.positions[k];
                text.Write(FormattableString.Invariant($"v {p.x:R} {p.y:R} {p.z:R}"));
                text.WriteLine(mesh.colours == null ? "" : Written(mesh.colours[k]));
            }

            foreach (Vector2 uv in mesh.uvs ?? Array.Empty<Vector2>())
                text.WriteLine(FormattableString.Invariant($"vt {uv.x:R} {uv.y:R}"));
            text.WriteLine("vn 0 1 0");
            for (int k = 0; k < mesh.triangles.Length; k += 3)
                text.WriteLine($"f {Corner(mesh.triangles[k])} {Corner(mesh.triangles[k + 1])} {Corner(mesh.triangles[k + 2])}");

            string Corner(int vertex) => mesh.uvs == null
                ? FormattableString.Invariant($"{vertex + 1}//1")
                : FormattableString.Invariant($"{vertex + 1}/{vertex + 1}/1");
        }

        // Shares of one, as programs write them behind the place.
        private static string Written(Color32 colour) => FormattableString.Invariant(
            $" {colour.r / 255f:0.####} {colour.g / 255f:0.####} {colour.b / 255f:0.####}");
    }
}
