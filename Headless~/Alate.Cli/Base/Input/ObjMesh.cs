using UnityEngine;

namespace Alate.Cli;

/// <summary>The triangles of a Wavefront OBJ file.</summary>
internal sealed class ObjMesh
{
    /// <summary>[vertex] From <see cref="Origin"/>.</summary>
    public Vector3[] Positions { get; init; }

    /// <summary>
    /// Origin from which the positions are counted, in the file's space: zero, and for a mesh far from the file's origin its middle, so
    /// that its shape is not lost in single precision.
    /// </summary>
    public (double X, double Y, double Z) Origin { get; init; }

    /// <summary>[vertex] Null unless every corner of the file has one.</summary>
    public Vector3[] Normals { get; init; }

    /// <summary>[vertex] Null unless every vertex of the file has one.</summary>
    public Color32[] Colours { get; init; }

    /// <summary>[vertex] Null unless every corner of the file has one.</summary>
    public Vector2[] Uvs { get; init; }

    public int[] Triangles { get; init; }

    /// <summary>File of the materials as the mesh names it; null where it names none.</summary>
    public string Library { get; init; }

    /// <summary>True for the name of such a file.</summary>
    public static bool IsNamed(string file) => string.Equals(Path.GetExtension(file), ".obj", StringComparison.OrdinalIgnoreCase);

    public SurfaceMesh ToSurface(string name) =>
        new() { name = name, positions = Positions, normals = Normals, uvs = Uvs, triangles = Triangles };
}
