using UnityEngine;

namespace Alate.Cli.Input;

/// <summary>The triangles of a Wavefront OBJ file.</summary>
internal sealed class ObjMesh
{
    public Vector3[] Positions { get; init; }

    /// <summary>[vertex] Null unless every corner of the file has one.</summary>
    public Vector3[] Normals { get; init; }

    /// <summary>[vertex] Null unless every vertex of the file has one.</summary>
    public Color32[] Colours { get; init; }

    public int[] Triangles { get; init; }

    public WingSurface ToWingSurface(string name) => new() { name = name, positions = Positions, normals = Normals, triangles = Triangles };
}
