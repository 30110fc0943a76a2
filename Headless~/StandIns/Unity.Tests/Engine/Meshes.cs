using UnityEngine;

namespace Unity.Tests.Engine;

internal static class Meshes
{
    /// <summary>The unit square of the xy plane, in two triangles that face -z.</summary>
    public static Mesh Square() => new()
    {
        name = "Square",
        vertices = new[] { Vector3.zero, Vector3.up, new Vector3(1f, 1f, 0f), Vector3.right },
        triangles = new[] { 0, 1, 2, 0, 2, 3 },
    };
}
