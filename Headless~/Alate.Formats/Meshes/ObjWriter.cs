using System.Globalization;
using UnityEngine;

namespace Alate.Formats;

/// <summary>Writes a mesh as a Wavefront OBJ file, coordinates as they are: with v, vt, vn and f.</summary>
internal static class ObjWriter
{
    /// <param name="mesh">With texture coordinates.</param>
    /// <param name="stream">Where to.</param>
    /// <param name="library">File of the mesh's material; null for none.</param>
    /// <param name="material">Name of that material.</param>
    public static void Write(SurfaceMesh mesh, Stream stream, string library = null, string material = null)
    {
        using var text = new StreamWriter(stream, new UTF8Encoding(false), leaveOpen: true) { NewLine = "\n" };
        if (library != null)
            text.WriteLine($"mtllib {library}\nusemtl {material}");
        foreach (Vector3 p in mesh.positions)
            text.WriteLine(string.Create(CultureInfo.InvariantCulture, $"v {p.x:R} {p.y:R} {p.z:R}"));
        foreach (Vector2 uv in mesh.uvs)
            text.WriteLine(string.Create(CultureInfo.InvariantCulture, $"vt {uv.x:R} {uv.y:R}"));
        text.WriteLine("vn 0 1 0");
        for (int k = 0; k < mesh.triangles.Length; k += 3)
            text.WriteLine($"f {Corner(mesh.triangles[k])} {Corner(mesh.triangles[k + 1])} {Corner(mesh.triangles[k + 2])}");
    }

    private static string Corner(int vertex) => string.Create(CultureInfo.InvariantCulture, $"{vertex + 1}/{vertex + 1}/1");
}
