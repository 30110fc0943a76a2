using System.Collections.Generic;
using UnityEngine;

namespace Unity.StandIns;

/// <summary>Meshes that were drawn at once, with the material of the last pass; kept while a test looks.</summary>
[StandInExtension]
public static class DrawnMeshes
{
    private static Material s_Material;

    /// <summary>Mesh, place, copy of the material, and whether edges alone are drawn. Null keeps none, and no pass can be set.</summary>
    public static List<(Mesh Mesh, Matrix4x4 Place, Material Material, bool Edges)> Calls { get; set; }

    internal static bool Pass(Material material)
    {
        s_Material = material;
        return Calls != null;
    }

    internal static void Note(Mesh mesh, Matrix4x4 place) => Calls?.Add((mesh, place, new Material(s_Material), GL.wireframe));
}
